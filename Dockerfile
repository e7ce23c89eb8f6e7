# map_matcher for a robot with ROS Noetic:
#
#   docker build -t map_matcher .
#   docker run --rm --network host -v /path:/path map_matcher \
#     roslaunch map_matcher map_matcher.launch map:=/path/building.yaml session_map:=map
FROM ros:noetic

# Before the rest, so that a change of the sources installs nothing anew.
WORKDIR /map_matcher
COPY scripts/common.bash scripts/install_dependencies scripts/packages.txt scripts/
RUN scripts/install_dependencies build run && rm -rf /var/lib/apt/lists/*

# Only what was installed stays.
COPY . .
RUN scripts/build release && find build/release -mindepth 1 -maxdepth 1 ! -name .install -exec rm -rf {} +

# "--": else the setup file would take the command for its own arguments.
ENTRYPOINT ["bash", "-c", ". /map_matcher/build/release/.install/setup.bash -- && exec \"$@\"", "--"]
CMD ["bash"]
