/// \file What the options of qm-export may say.
#pragma once

#include "document/kind.h"
#include "document/option.h"
#include "export/export.h"

#include <array>
#include <string>

namespace qm {

class Tool;
struct Model;

/// What --format may say: a format, or that the output's name tells it.
enum class NamedFormat { ending, step, iges, obj, ply, glb };

template <> struct Choices<NamedFormat> {
    static constexpr std::array all{
        Choice<NamedFormat>{NamedFormat::ending, "ending", "what the ending of the output's name says"},
        Choice<NamedFormat>{NamedFormat::step, "step", "B-spline surfaces, STEP AP214"},
        Choice<NamedFormat>{NamedFormat::iges, "iges", "B-spline surfaces, IGES"},
        Choice<NamedFormat>{NamedFormat::obj, "obj", "quads, one group for every segment"},
        Choice<NamedFormat>{NamedFormat::ply, "ply", "quads with colours and segment numbers, binary"},
        Choice<NamedFormat>{NamedFormat::glb, "glb", "coloured triangles, one glTF node for every segment"}};
};

template <> struct Choices<LengthUnit> {
    static constexpr std::array all{Choice<LengthUnit>{LengthUnit::mm, "mm", "millimetres"},
                                    Choice<LengthUnit>{LengthUnit::cm, "cm", "centimetres"},
                                    Choice<LengthUnit>{LengthUnit::m, "m", "metres"},
                                    Choice<LengthUnit>{LengthUnit::inch, "inch", "inches"}};
};

template <> struct Choices<ColourBy> {
    static constexpr std::array all{
        Choice<ColourBy>{ColourBy::segment, "segment", "another colour for every segment"},
        Choice<ColourBy>{ColourBy::deviation, "deviation", "blue to red by the surface's largest deviation"}};
};

/// \throw UsageError  if neither the option nor the output's name tells the format
[[nodiscard]] ExportFormat exportFormat(NamedFormat format, const std::string& outputPath);

/// Tells the tool which options have an effect on which formats only.
void declareNeeds(Tool& tool, const ExportOptions& options, const NamedFormat& format);

/// When a file says that it was made.
/// \param text  a date, with or without a time of day, UTC: "2026-11-22T10:00:00"; or "mesh" for when the mesh's
/// file was changed last
/// \throw Error  if it is none of them, or the mesh's file is gone
[[nodiscard]] std::string exportDate(const std::string& text, const std::string& meshPath);

/// What a document must hold. Quads need no surfaces, unless they are coloured by them.
[[nodiscard]] Kind neededKind(const ExportOptions& options);

/// Counts what a shape has, and warns of all that keeps it from being a solid that other programs take.
/// \return false  if they will hardly take it: it has faults or gaps, or is too small for the format
[[nodiscard]] bool reportShape(Tool& tool, const ShapeReport& shape, const Model& model, LengthUnit unit);

} // namespace qm
