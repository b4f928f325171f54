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

/// \throw UsageError  if neither the option nor the output's name determines the format
[[nodiscard]] ExportFormat exportFormat(NamedFormat format, const std::string& outputPath);

/// \param date  empty, or see `exportDate` (cli/tools/export_date.h)
/// \throw Error  if no product can have this name, because it is too long or not UTF-8, or if that is no date
void verifyNameAndDate(const std::string& name, const std::string& date);

/// Declares which options have an effect on some formats only.
void declareNeeds(Tool& tool, const ExportOptions& options, const NamedFormat& format);

/// The kind that a document must have. Quads need no surfaces, unless these determine their colours.
[[nodiscard]] Kind neededKind(const ExportOptions& options);

/// Adds the figures of a shape, if there is one, to the statistics, and warns of everything that keeps it
/// from being a usable solid.
/// \return exitUnmet  if other programs will hardly accept it: it has faults or gaps, or is too small for the
/// format; else exitDone
[[nodiscard]] int reportShape(Tool& tool, const std::optional<ShapeReport>& shape, const Model& model,
                              LengthUnit unit);

} // namespace qm
