#include <memory>
#include <optional>
#include <stdexcept>

#include <planish/evolve/evolve.h>
#include <planish/measure/flattenability.h>
#include <planish/report/json_report.h>

#include <pybind11/stl.h>

#include "arrays.h"
#include "commands/jobs.h"
#include "flags/constraint_flags.h"
#include "job.h"
#include "keywords.h"
#include "mesh_data.h"
#include "own_method.h"
#include "pickle.h"
#include "shell/failures.h"
#include "text/summary.h"

namespace planish::python {

namespace {

struct EvolveOutcome {
  std::string name;
  cli::Evolved evolved;
  std::optional<cli::CutOutcome> cut;
  Unit unit = Unit::mm;
  std::vector<std::string> notes = {};
};

/// @param function that makes the sweeps, None for a method of the library
cli::EvolveRequest request_of(const py::object& function, const cli::Arguments& arguments,
                              Job& job) {
  if (function.is_none()) return cli::evolve_request_from(arguments);
  return cli::evolve_request_from(arguments, method_of(function, job));
}

EvolveOutcome evolve_mesh(const MeshData& data, const py::dict& keywords, py::object progress) {
  const auto [function, flags] = own_function_of(keywords);
  const cli::Arguments arguments = arguments_on(data, "evolve", flags);
  Job job(arguments, std::move(progress));
  cli::EvolveRequest request = request_of(function, arguments, job);
  EvolveOutcome outcome = job.run([&](cli::Session& session) {
    cli::CutInput input = cut_input(data, arguments, session);
    const Patch patch(std::move(input.mesh));
    request.symmetric_in = input.symmetric_in;
    cli::note_obstruction(session, patch);
    return EvolveOutcome{data.name, cli::evolve_as_asked(patch, {}, request, arguments, session),
                         input.cut, request.unit};
  });
  outcome.notes = notes_on(data, arguments, job.notes());
  return outcome;
}

/// The state after a sweep.
struct Sweep {
  SweepRecord record;
  std::vector<Vec3> positions;
};

/// An evolution, one sweep at a time.
class Sweeps {
 public:
  Sweeps(const MeshData& data, const py::dict& keywords)
      : function_(own_function_of(keywords).first),
        arguments_(arguments_on(data, "evolve", own_function_of(keywords).second)),
        job_(arguments_, py::none()) {
    for (const char* flag : {"--remesh", "--smooth-first", "--symmetric"}) {
      if (arguments_.has(flag))
        throw cli::UsageError("flag " + std::string(flag) + " does not go with single sweeps");
    }
    const cli::EvolveRequest request = request_of(function_, arguments_, job_);
    stopping_ = request.stopping;
    job_.run([&](cli::Session& session) {
      patch_ = Patch(cut_input(data, arguments_, session).mesh);
      const Constraints constraints = cli::constraints_from(arguments_, patch_, session);
      evolver_.emplace(patch_, request.method, constraints, session.silent_context());
      ended_ = has_met(summarise_defects(angle_defects(patch_), 0).e_max);
      return true;
    });
  }

  Sweep next() {
    const Turn turn(*this);
    if (ended_ || made_ >= stopping_.max_sweeps) throw py::stop_iteration();
    ended_ = true;  // where the work fails, nothing else may be asked of it
    Sweep sweep = job_.run([&](cli::Session&) {
      const SweepRecord record = evolver_->step();
      if (made_ + 1 == stopping_.max_sweeps) evolver_->prolong_to_finest();
      return Sweep{record, evolver_->positions()};
    });
    ++made_;
    ended_ = has_met(sweep.record.e_max) || sweep.record.status != SweepStatus::running;
    return sweep;
  }

  const Patch& patch() const { return patch_; }

 private:
  /// Lets one thread work at a time.
  struct Turn {
    explicit Turn(Sweeps& sweeps) : of(sweeps) {
      if (of.busy_) throw std::runtime_error("another thread is at work on these sweeps");
      of.busy_ = true;
    }
    ~Turn() { of.busy_ = false; }
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;
    Sweeps& of;
  };

  /// As evolve() has it: what is flat to the last digits is not worked on.
  bool has_met(double e_max) const { return e_max <= std::max(stopping_.target_e_max, 1e-12); }

  py::object function_;
  cli::Arguments arguments_;
  Job job_;
  Stopping stopping_;
  Patch patch_;
  std::optional<Evolver> evolver_;
  int made_ = 0;
  bool ended_ = false;
  bool busy_ = false;  // read and written with Python's lock held
};

void register_sweeps(py::module_& module) {
  py::class_<Sweep>(module, "Sweep", "A patch after one sweep.")
      .def(pickled<Sweep>())
      .def_property_readonly("sweep", value_at<&Sweep::record, &SweepRecord::sweep>,
                             "Its number, from 1.")
      .def_property_readonly("e_max", value_at<&Sweep::record, &SweepRecord::e_max>,
                             "Largest |angle defect|, radians.")
      .def_property_readonly("e_avg", value_at<&Sweep::record, &SweepRecord::e_avg>,
                             "Mean |angle defect|, radians.")
      .def_property_readonly("energy", value_at<&Sweep::record, &SweepRecord::energy>,
                             "Sum of squared angle defects, square radians.")
      .def_property_readonly("moved", value_at<&Sweep::record, &SweepRecord::moved>,
                             "How many vertices the sweep moved.")
      .def_property_readonly("seconds", value_at<&Sweep::record, &SweepRecord::seconds>,
                             "Time since the first sweep began.")
      .def_property_readonly(
          "vertices", view_at<&Sweep::positions>,
          "Places after the sweep, shape (n, 3), model units; a read-only view.");
  py::class_<Sweeps>(module, "Sweeps", "An evolution as an iterator over its sweeps.")
      .def("__iter__", [](Sweeps& sweeps) -> Sweeps& { return sweeps; })
      .def("__next__", &Sweeps::next)
      .def_property_readonly("faces", view_at<&Sweeps::patch, &Patch::triangles>,
                             "Vertices of the triangles, shape (m, 3); a read-only view.");
  module.def(
      "sweeps",
      [](const MeshData& data, const py::dict& keywords) {
        return std::make_unique<Sweeps>(data, keywords);
      },
      py::arg("mesh"), py::arg("keywords"));
}

}  // namespace

void register_evolve(py::module_& module) {
  py::class_<EvolveOutcome>(module, "EvolveResult", "A patch that was evolved.")
      .def(pickled<EvolveOutcome>())
      .def_readonly("name", &EvolveOutcome::name, "Of the patch.")
      .def_readwrite("notes", &EvolveOutcome::notes, "What the program said on the way.")
      .def_property_readonly(
          "vertices", view_at<&EvolveOutcome::evolved, &cli::Evolved::mesh, &TriMesh::positions>,
          "Places after the last sweep, shape (n, 3), model units; a read-only view.")
      .def_property_readonly(
          "faces", view_at<&EvolveOutcome::evolved, &cli::Evolved::mesh, &TriMesh::triangles>,
          "Vertices of the triangles, shape (m, 3); a read-only view.")
      .def_property_readonly(
          "stop",
          [](const EvolveOutcome& outcome) {
            return std::string(to_string(outcome.evolved.report.result.stop));
          },
          "Why it ended: reached_target, converged, sweep_limit, ...")
      .def_property_readonly(
          "target_met",
          [](const EvolveOutcome& outcome) {
            return outcome.evolved.report.outcome().target_met();
          },
          "Whether e_max is at the target; without one, whether it is 0 but for rounding.")
      .def_property_readonly(
          "figures",
          [](const EvolveOutcome& outcome) {
            return figures_of(json_report(outcome.evolved.report, outcome.evolved.cautions,
                                          outcome.unit, cli::figures_of_cut(outcome.cut)));
          },
          "All figures, with the keys of the program's --json.");
  register_sweep_input(module);
  module.def("evolve", evolve_mesh, py::arg("mesh"), py::arg("keywords"), py::arg("progress"));
  register_sweeps(module);
}

}  // namespace planish::python
