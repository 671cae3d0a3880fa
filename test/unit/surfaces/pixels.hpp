/// Pixels of a picture, counted by colour.
#pragma once
#include <array>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

namespace sph::test
{

class Pixels
{
    vtkNew<vtkPNGReader> reader_;

public:
    using Colour = std::array<int, 3>; ///< red, green, blue from 0 to 255

    explicit Pixels(const std::filesystem::path& png)
    {
        reader_->SetFileName(png.c_str());
        reader_->Update();
    }
    int width() const { return reader_->GetOutput()->GetDimensions()[0]; }
    int height() const { return reader_->GetOutput()->GetDimensions()[1]; }

    /// Share of all pixels that are of such colours and lie between these parts of the width.
    double share(const std::function<bool(const Colour&)>& such, double left = 0, double right = 1) const
    {
        const auto* pixel = static_cast<const unsigned char*>(reader_->GetOutput()->GetScalarPointer());
        const int wide = width(), all = wide * height();
        int found = 0;
        for (int k = 0; k < all; ++k, pixel += 3)
        {
            const double x = (k % wide + 0.5) / wide;
            if (x >= left && x < right && such({pixel[0], pixel[1], pixel[2]})) ++found;
        }
        return double(found) / all;
    }
};

inline bool isWhite(const Pixels::Colour& c) { return c == Pixels::Colour{255, 255, 255}; }
inline bool isBlue(const Pixels::Colour& c) { return !isWhite(c) && c[2] > c[0] + 40; }
inline bool isGrey(const Pixels::Colour& c) { return !isBlue(c) && std::abs(c[0] - c[2]) < 40 && c[0] > 60 && c[0] < 235; }
/// The ends of the scale of fields, whichever the light: dark blue with red in it, and yellow.
inline bool isLeast(const Pixels::Colour& c) { return c[2] > 1.15 * c[0] && c[0] > 1.5 * c[1] && c[2] > 40; }
inline bool isMost(const Pixels::Colour& c) { return c[0] > 150 && c[1] > 130 && c[2] < 0.5 * c[1]; }

inline bool isInstalled(const std::string& program) { return std::system(("command -v " + program + " > /dev/null 2>&1").c_str()) == 0; }

}
