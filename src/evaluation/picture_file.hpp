/// \file
/// Pictures as files. Private to the room.
#pragma once

#include <string>

namespace cv {
class Mat;
}  // namespace cv

namespace map_matcher::evaluation {

/// Writes a picture in the format that the path's ending names; it is there whole or not at all. Throws
/// std::runtime_error.
void writePicture(const std::string& path, const cv::Mat& image);

}  // namespace map_matcher::evaluation
