// The names on which documents and the library agree. What is found in a document belongs to whose prefix it has:
// "anna/mimo_location" is Anna's; without one it belongs to the scene, or to its only infant.
#pragma once

namespace mimo::names {

// Said by a room, in its <custom> section. models/README.md explains them.
constexpr const char* kTask = "mimo:task";             // text: what is to be done
constexpr const char* kFrameSkip = "mimo:frame_skip";  // number: how many physics steps a step has
constexpr const char* kInfants = "mimo:infants";       // text: names of those whom it is made for
constexpr const char* kPlaces = "mimo:place";          // numbers: where they are put, seven values a place
constexpr const char* kInfant = "mimo:infant";         // text: the file of its recipe for an infant
constexpr const char* kMainClass = "mimo:main";        // class: main defaults, where something stands beside them

// Said by a room whose task is "behaviour". docs/guide/behaviours.md explains them.
constexpr const char* kReached = "mimo:reached";          // text: what is measured, and what it has to reach
constexpr const char* kBehaviour = "mimo:behaviour";      // text: what the infant does, in words
constexpr const char* kSeconds = "mimo:episode_seconds";  // number: after which an episode is cut off
constexpr const char* kPhases = "mimo:phases";            // numbers: how long each phase of an episode lasts, seconds
constexpr const char* kStillJoint = "mimo:still_joint";   // text: a joint that is held in the first, third, ... phase
constexpr const char* kNorm = "mimo:norm";                // numbers: months, early, middle and late; 0: not known
constexpr const char* kNormAbout = "mimo:norm_about";     // text: which statistics these are
constexpr const char* kNormSource = "mimo:norm_source";   // text: who published them

// Said by a recipe.
constexpr const char* kActs = "mimo:acts";             // text: groups of motors that act
constexpr const char* kStill = "mimo:still";           // text: how the names of motors begin that do not
constexpr const char* kSenses = "mimo:senses";         // text: senses that are on
constexpr const char* kActuation = "mimo:actuation";   // text: how its actions move it
constexpr const char* kBodies = "mimo:bodies";         // text: bodies that it is made for
constexpr const char* kRootJoint = "mimo:root_joint";  // text: what its free joint is called
constexpr const char* kTouch = "mimo:touch";           // tuple: bodies with skin, and how far its sensors are apart

// Said by a recipe, of what goes with an infant's size.
constexpr const char* kWithStature = "mimo:with_stature";  // text: bodies that are built to its stature
constexpr const char* kWithArm =
    "mimo:with_arm";  // text: pairs of a body and the infant's from which it is an arm away

// A stored pose.
constexpr const char* kPoseSlack = "mimo:pose_slack";  // number: by how much a joint may have to miss it at an age, rad
constexpr const char* kRootPose = "mimo:root";         // numbers: position and orientation of an infant's root
constexpr const char* kPose = "mimo:pose";             // tuple: hinges and slides, and where they are

// Of an infant that is not the one of 18 months, said by the library itself.
constexpr const char* kGrowth = "mimo:growth";  // numbers: age in months; stature, and length of its arms, as factors
// Of each geom of its tree at 18 months, by id: where its touch sensors are placed before they grow with it.
constexpr const char* kBornSizes = "mimo:born_sizes";    // numbers: three sizes, as MuJoCo's
constexpr const char* kBornPlaces = "mimo:born_places";  // numbers: its position in its body
// Of each hinge of its tree at 18 months, by id, where one goes less far or further now: its muscles keep their levers.
constexpr const char* kBornRanges = "mimo:born_ranges";  // numbers: lower and upper limit, rad

// Of an infant's parts: a body, and how names of others begin.
constexpr const char* kRootBody = "mimo_location";
constexpr const char* kJoint = "robot:";         // hinges, "robot:left_elbow"
constexpr const char* kMotor = "act:";           // motors, "act:left_elbow"
constexpr const char* kSensor = "proprio:";      // torque sensors, "proprio:left_elbow"
constexpr const char* kFace = "mimo_face_";      // materials of its head, "mimo_face_happy"
constexpr const char* kNameless = "mimo:body:";  // bodies without a name, while a document's inertias are worked out

}  // namespace mimo::names
