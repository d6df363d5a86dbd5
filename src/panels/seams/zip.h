#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "panels/piece/panel_mesh.h"
#include "panels/seams/seam_chains.h"
#include "panels/seams/seam_state.h"

namespace planish {

/// Closes seams of a mesh, run after run, as long as each piece keeps the limit of strain by its
/// potential: first the run that costs least strain for what it saves of J, in steps of 0.15 and
/// 0.05 of the root of the area and of an edge (docs/panels.md). Pieces over the limit and small
/// ones are joined to others before that.
class Zip {
 public:
  using MayJoin = std::function<bool(const SeamState&, const SeamRun&)>;

  /// @param chains of the mesh of the states, must outlive it
  /// @param favour of each chain: what its costs are multiplied by; empty: 1 everywhere
  /// @param may_join asked before pieces are joined along a run; empty: they may
  Zip(const std::vector<SeamChain>& chains, double limit, const SeamPrices& prices,
      std::vector<double> favour = {}, MayJoin may_join = {})
      : chains_(chains),
        limit_(limit),
        prices_(prices),
        favour_(std::move(favour)),
        may_join_(std::move(may_join)) {}

  /// One step after the other, until nothing can be closed.
  /// @param held by edge: 1 for those that stay open
  void run(SeamState& state, const OpenEdges& held);

 private:
  /// Edges of a chain that might be closed together.
  struct Action {
    std::size_t chain, first, last;  ///< edges from `first` to before `last`
    int way;                         ///< 0 onwards, 1 backwards, 2 in the middle, 3 all of a run
  };
  struct Outcome {
    PanelPiece piece;
    double ratio = 0.0;  ///< infinite where it must not be
    double more = 0.0;   ///< energy; infinite where that is not known
  };
  using Key = std::tuple<std::size_t, std::size_t, std::size_t, Index, Index>;

  std::vector<Action> actions(const SeamState& state, const OpenEdges& held, double step) const;
  void add_actions_of(const SeamState& state, std::size_t chain, std::size_t first,
                      std::size_t last, double step, std::vector<Action>& found) const;
  std::vector<Index> edges_of(const Action& action) const;
  Key key_of(const SeamState& state, const Action& action) const;
  Outcome try_out(const SeamState& state, const Action& action) const;
  /// Whether it joins two pieces of which one is over the limit or small.
  bool joins_unfit(const SeamState& state, const Action& action) const;
  /// The one of least ratio; nothing where none may be closed.
  std::optional<std::size_t> best_of(const SeamState& state, const std::vector<Action>& all,
                                     double step);
  bool close_best(SeamState& state, const OpenEdges& held, double step);

  const std::vector<SeamChain>& chains_;
  double limit_;
  SeamPrices prices_;
  std::vector<double> favour_;
  MayJoin may_join_;
  std::map<Key, Outcome> known_;
  using Place = std::tuple<double, std::size_t, int>;  // step, chain, way
  /// Whether an action would break the limit if it cost nearly as much as it last did.
  bool is_hopeless(const SeamState& state, const Action& action, double step) const;
  std::map<Place, double> last_ratio_, last_more_;
};

}  // namespace planish
