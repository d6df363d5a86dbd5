#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "draw/dxf/dxf_layers.h"
#include "draw/dxf/dxf_tags.h"

namespace planish {

/// The numbers by which entries of an R2000 file refer to each other, in hexadecimal digits.
class DxfHandles {
 public:
  std::string next();

 private:
  std::size_t last_ = 0;
};

/// What an R2000 file must have besides its header and what is drawn: tables, blocks, dictionaries.
class R2000Frame {
 public:
  /// Of the next entry.
  std::string next_handle() { return handles_.next(); }
  /// The handle of the block that holds what is drawn.
  const std::string& model_space() const { return model_space_; }

  DxfTags tables_and_blocks(const std::vector<DxfLayer>& layers);
  DxfTags objects_section();

 private:
  /// @return the handle of the table
  std::string begin_table(DxfTags& tags, std::string_view name, std::size_t entries);
  void begin_entry(DxfTags& tags, std::string_view kind, const std::string& table,
                   std::string_view subclass, std::string_view name,
                   const std::optional<std::string>& handle = {});
  void add_line_types(DxfTags& tags);
  void add_layers(DxfTags& tags, const std::vector<DxfLayer>& layers);
  void add_styles(DxfTags& tags);
  void begin_block_entity(DxfTags& tags, std::string_view kind, const std::string& record,
                          std::string_view subclass);
  void add_block(DxfTags& tags, std::string_view name, const std::string& record);

  DxfHandles handles_;
  std::string model_space_ = handles_.next(), paper_space_ = handles_.next();
};

}  // namespace planish
