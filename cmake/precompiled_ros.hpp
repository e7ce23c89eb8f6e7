/// \file
/// What nearly every source of ros/ includes, compiled once for each library.
#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <ros/console.h>
#include <ros/node_handle.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_ros/buffer.h>

#include "precompiled.hpp"
