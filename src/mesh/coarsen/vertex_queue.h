#pragma once

#include <cstddef>
#include <vector>

#include <planish/core/vec.h>

namespace planish {

/// Vertices by a key that may change, the smallest first, of equal keys the smallest number: a
/// binary heap that knows where each vertex is.
/// @tparam Key float where keys have few digits, which halves the memory
template <class Key>
class VertexQueue {
 public:
  explicit VertexQueue(std::size_t vertex_count) : places_(vertex_count, k_outside) {}

  /// Makes room for this number.
  void reserve(std::size_t count) { heap_.reserve(count); }

  bool empty() const { return heap_.empty(); }
  Index top() const { return heap_.front().vertex; }
  Key top_key() const { return heap_.front().key; }

  /// Puts v in, or changes its key.
  void set(Index v, Key key) {
    if (places_[v] == k_outside) {
      places_[v] = static_cast<Index>(heap_.size());
      heap_.push_back({key, v});
    } else {
      heap_[places_[v]].key = key;
    }
    sink(rise(places_[v]));
  }

  void remove(Index v) {
    const Index place = places_[v];
    if (place == k_outside) return;
    places_[v] = k_outside;
    const Entry last = heap_.back();
    heap_.pop_back();
    if (place == heap_.size()) return;
    put(place, last);
    sink(rise(place));
  }

 private:
  static constexpr Index k_outside = static_cast<Index>(-1);

  struct Entry {
    Key key;
    Index vertex;
    bool operator<(const Entry& other) const {
      return key != other.key ? key < other.key : vertex < other.vertex;
    }
  };

  void put(Index place, Entry entry) {
    heap_[place] = entry;
    places_[entry.vertex] = place;
  }

  Index rise(Index place) {
    const Entry entry = heap_[place];
    for (; place > 0 && entry < heap_[(place - 1) / 2]; place = (place - 1) / 2)
      put(place, heap_[(place - 1) / 2]);
    put(place, entry);
    return place;
  }

  void sink(Index place) {
    const Entry entry = heap_[place];
    for (std::size_t child = 2 * std::size_t{place} + 1; child < heap_.size();
         child = 2 * std::size_t{place} + 1) {
      if (child + 1 < heap_.size() && heap_[child + 1] < heap_[child]) ++child;
      if (!(heap_[child] < entry)) break;
      put(place, heap_[child]);
      place = static_cast<Index>(child);
    }
    put(place, entry);
  }

  std::vector<Entry> heap_;
  std::vector<Index> places_;
};

}  // namespace planish
