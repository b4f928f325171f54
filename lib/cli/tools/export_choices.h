/// \file The values of qm-export's options, and their meaning.
#pragma once

#include "document/kind.h"
#include "document/options/option.h"
#include "export/export.h"

#include <string>

namespace qm {

class Tool;
struct Model;

/// The values of --format: a format, or to use the extension of the output's name.
enum class NamedFormat { ending, step, iges, obj, ply, glb };

template <> struct Choices<NamedFormat> {
    using enum NamedFormat;
    static constexpr Choice<NamedFormat> all[]{
        {ending, "ending", "what the ending of the output's name says"},
        {step, "step", "B-spline surfaces, STEP AP214"},
        {iges, "iges", "B-spline surfaces, IGES"},
        {obj, "obj", "quads, one group for every segment"},
        {ply, "ply", "quads with colours and segment numbers, binary"},
        {glb, "glb", "coloured triangles, one glTF node for every segment"}};
};

template <> struct Choices<LengthUnit> {
    using enum LengthUnit;
    static constexpr Choice<LengthUnit> all[]{
        {mm, "mm", "millimetres"}, {cm, "cm", "centimetres"}, {m, "m", "metres"}, {inch, "inch", "inches"}};
};

template <> struct Choices<ColourBy> {
    using enum ColourBy;
    static constexpr Choice<ColourBy> all[]{
        {segment, "segment", "another colour for every segment"},
        {deviation, "deviation", "blue to red by the surface's largest deviation"}};
};

/// Declares which options have an effect on some formats only. Once the command line has been read, sets the
/// format in the options, and refuses what neither --format nor the output's name determine, and names and
/// dates that no product can have.
/// \param date  empty, or see `exportDate` (cli/tools/export_date.h)
void declareChecks(Tool& tool, ExportOptions& options, const NamedFormat& format, const std::string& date);

/// The name of a product that has none of its own: that of the mesh's file, without its ending, and with ? in
/// the place of bytes that are no UTF-8.
[[nodiscard]] std::string productName(const std::string& meshPath);

/// The kind that a document must have. Quads need no surfaces, unless these determine their colours.
[[nodiscard]] Kind neededKind(const ExportOptions& options);

/// Adds the figures of a shape, if there is one, to the statistics, and warns of everything that keeps it
/// from being a usable solid.
/// \return exitUnmet  if other programs will hardly accept it: it has faults or gaps, or is too small for the
/// format; else exitDone
[[nodiscard]] int reportShape(Tool& tool, const std::optional<ShapeReport>& shape, const Model& model,
                              LengthUnit unit);

} // namespace qm
