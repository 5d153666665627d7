function mimo_options()
% MIMO_OPTIONS  All options, and the words that they take.
%   mimo_options() shows this page.
%   An option that takes words also takes the numbers of mimo.h. Several words that combine go into a cell
%   array, {'rgb', 'depth'}; {} is none of them. In struct() a cell array needs braces, {{'rgb', 'depth'}}.
%   Experimental options may change with any version: docs/abi.md.
%
%   An infant: mimo_create, mimo_scene_add(scene, 'agent', ...):
%     place                 A word of Place: its point that lies at position. Default: the scene's.
%     name                  Prefix of its fields and model names, "anna/...": letters, digits, '_', '-', '.'; ""
%                           (default): none, for a single agent.
%     body                  "mitten" (default) or "fingers" (five fingers, a big toe); with "-mirrored" appended the
%                           left side mirrors the right one. "scene": the body is in the scene's MJCF.
%     position              Of the point selected by place, m, world frame; unused with 'scene'.
%     orientation           Of the root body, w x y z; need not be normalised; unused with 'scene'.
%     proprioception        Words of Proprioception; {}: no proprioception. Default, as the original: 'velocity',
%                           'torque', 'limit', 'actuation' and 'position'.
%     vestibular            Words of Vestibular; {}: no sense of balance. Default: 'acceleration' and
%                           'angular_velocity'.
%     limit_threshold       Distance from a joint's limit at which limit sensors start, radians, > 0. Default 0.035.
%     vision                Words of Vision of both eyes; {}: no vision. Default 'rgb'.
%     vision_height         Pixels, 1 to 4096. Default 256.
%     vision_width          Pixels, 1 to 4096. Default 256.
%     actuation             A word of Actuation. Default torque.
%     vision_fovy           Vertical field of view in degrees, 1 to 170; 0: the camera's own (60).
%     vision_foveation      L, 0.01 to 100: colour pictures show their middle L / ln(1 + L) times as large and their rim
%                           smaller; 0 (default): as drawn. See mimo_directions.
%     acts                  Words of Act: the parts whose motors it controls; {}: the scene's choice.
%     normalize_actions     1: actions go from -1 to 1, mapped linearly to their range; 0: they have their own range.
%     touch                 Words of Touch; {}: no touch. Default 'force'.
%     touch_response        A word of TouchResponse: how a touch spreads over sensors. Default 'linear'.
%     touch_frame           A word of TouchFrame: of touch/force with three components. Default 'body'.
%     reflexes              Words of Reflex; adds the field reflex/activation; {} (default): none. Experimental.
%     touch_scale           Divides the distances between sensors, 0.001 to 1000: 2 gives 4 times as many. Default 1.
%     touch_slip_threshold  Slip below this is 0, since MuJoCo's friction creeps; m/s, >= 0. Default 0.005.
%     face                  The face that it starts with, see mimo_names('face'); unless set: neutral.
%     root                  With body "scene": the body of the model that, with its children, is the agent; "world": the
%                           whole model. Unless set: an infant.
%     vestibular_at         Site or body whose motion the vestibular sense feels; unless set: the infant's head.
%     hearing               Words of Hearing; {} (default): no hearing. Experimental.
%     voice                 1: an infant's voice, with four actions after the motors' actions: "voice:loudness", 0
%                           (silent) to 1 (a cry); "voice:pitch", -0.5 to 0.5 octaves; "voice:opening" and
%                           "voice:front", 0.7 to 1.3 times the first and second formant of its age. Every agent with
%                           hearing hears it, see docs/guide/hearing.md. 0 (default): no voice. Experimental.
%     strength              Factor of what an infant's motors and muscles can do, 0.01 to 100, at any age on top of its
%                           growth's; 0 (default): 1. It is in 'actuator_gear' of worlds, not in the MJCF of scenes. Not
%                           with 'position', which uses no motors.
%
%   Its age and size, with those of an infant:
%     sex                   A word of Sex. Default 'mean'.
%     age                   Age in months, 0 (a newborn) to 24, for size and mass. Default 18.
%     physiological_age     Months, 0 to 24, for strength, range of motion and tone. Experimental.
%     growth                A word of GrowthModel. Default 'who'. Experimental.
%     z_length              Its length in standard deviations from the median of age and sex, -3 to 3.
%     z_weight              The same for its weight.
%     z_head                The same for its head's circumference.
%     percentile            Percent, 1 to 99.865: sets all three z-scores, which must then be 0; 0: not used.
%     strength_exponent     A muscle's strength per cross-section is proportional to this power of the median length at
%                           the physiological age, 0 to 5; 0: equal at all ages. Default 1.7. Experimental.
%     neck_strength         Factor of the neck's strength at its age, 0 to 10. Default 1. Experimental.
%     birth_tone            Factor of a newborn's joint stiffness, 0.1 to 10; it falls to 1 at 6 months. Default 1.5.
%                           Experimental.
%     contracture           Share of the young infant's limited extension of hips, knees and elbows that applies, 0 to
%                           1. Default 1. Experimental.
%     absolute              1: length and weight are the WHO's; 0 (default): they are the WHO's relative to the body of
%                           18 months, which is 4.5 % shorter and 3 % heavier than the median. Experimental.
%     keep_spacing          1: touch sensors keep the spacing of 18 months, so a smaller body has fewer; 0 (default):
%                           their number stays and their spacing grows with the body. Experimental.
%     maturity              Words of Mature; {} (default): 'body'. Experimental.
%
%   Simulation and pictures: mimo_create:
%     frame_skip            Physics steps per environment step, 1 to 1000; each is one time step of the model, 5 ms in
%                           built-in scenes. 0 (default): the scene's, usually 2.
%     jacobian              A word of Jacobian. Experimental.
%     disable               Words of Disable.
%     renderer              "ray": libmimo's, on the CPU; "osmesa", "gl": MuJoCo's, on the CPU or a graphics card;
%                           "none": no pictures, vision must be off; "auto" (default): ray if the scene allows it, else
%                           osmesa.
%     max_steps             Steps after which an episode is truncated; 0: the task's parameter episode_steps.
%     timing                1: enables mimo_timing; costs a few clock reads per step. Experimental.
%     task                  See mimo_names('task'); unless set: the scene's. Every agent performs the task separately.
%     render                Words of Render: effects that pictures show; the others cost nothing. Default: all except
%                           fog. Experimental.
%     samples               Samples per pixel for smooth edges: 1, 4, 16 or 64 (OpenGL may use fewer); 0: one ray, or
%                           the model's setting for OpenGL.
%     render_threads        Threads of the ray renderer for one picture, 1 to 64, including the caller's. They do not
%                           change pictures. Default 1, the best choice in batches.
%     step_contacts         1: records the contacts of each step ('step_contact'). Default 0, at no cost.
%
%   Many worlds: mimo_create:
%     worlds                1 (default) to 1048576.
%     threads               Up to 4096; 0 (default): the cores that the caller may use. Never more than worlds.
%     autoreset             A word of Autoreset. When one agent's episode ends, the others' are truncated.
%     restart_failed        1: a world whose simulation fails starts a new episode, as after an end (with 'none': in the
%                           same step). 0: it stays failed until mimo_reset or a loaded state.
%
%   Documents: mimo_create, mimo_scene:
%     model_dir             A folder with built-in models to use in place of the library's own.
%     max_file_bytes        Bytes of each file that is read. Default 268435456.
%     max_pixels            Pixels of a texture, height field or shadow map. Default 67108864.
%     max_vertices          Vertices of a mesh or skin, and its faces. Default 1000000.
%     max_elements          Elements of the document, including those of composites. Default 40000.
%     max_keyframes         Default 10000.
%     max_iterations        Iterations of each solver in a physics step. Default 10000.
%     max_world_bytes       Estimated bytes of one world and its model (textures, meshes, ...). Default 4294967296;
%                           MuJoCo 2.2 itself allows a model of 2147483647 bytes.
%     confined              1: includes and assets must lie in the folder of the document that names them, or below; 0:
%                           anywhere.
%     max_compile_ms        Estimated milliseconds of MuJoCo's compiler, on one core of a processor of 2022. While it
%                           runs, the process makes no other world. Above 1000 a message is logged. Default 10000.
%
%   An object: mimo_scene_add(scene, 'object', ...):
%     shape                 A word of Shape.
%     name                  Name of its body and its geom; required, unique among bodies and geoms.
%     size                  Metres, by shape; entries that the shape does not use have no effect.
%     position              Metres, world frame.
%     orientation           w x y z; need not be normalised.
%     mass                  Kilograms; 0: a density of 1000 kg/m^3.
%     rgba                  Colour, 0 to 1.
%     fixed                 1: part of the world; 0: it moves freely.
%
%   A model: mimo_scene_add(scene, 'model', ...):
%     fixed                 1: it gets no free joint; 0: it moves freely, unless its body has joints of its own.
%     name                  Required: letters, digits, '_', '-', '.'. With a '/' it precedes all names of the document.
%     file                  Path of an MJCF file; its includes and meshes are relative to its folder.
%     xml                   Or MJCF text; relative paths start from the working directory.
%     position              Position of its body, metres, world frame; replaces the document's.
%     orientation           w x y z; need not be normalised.
%
%   A camera: mimo_scene_add(scene, 'camera', ...):
%     outputs               Words of Vision, at least one. Default 'rgb'.
%     name                  A camera of the scene's MJCF or of an infant, "anna/eye_left"; with placed = 1 the name of a
%                           new one.
%     height                Pixels, 1 to 4096. Default 256.
%     width                 Pixels, 1 to 4096. Default 256.
%     fovy                  Vertical field of view in degrees, 1 to 170; 0: the camera's own, 45 for a new one.
%     placed                1: make the camera, placed by the members below; 0: it is in the model.
%     body                  Name in the model of the body that carries it; unless set: it is fixed in the world.
%     position              Its position, metres, in the frame of the body.
%     look_at               The point in the middle of its picture, metres, in the frame of the body, whose z axis
%                           points up in the picture.
%
%   A further field: mimo_scene_add(scene, 'field', ...):
%     name                  Name of the field, "toys/position"; required, unique among fields.
%     relative_to           For positions, orientations, poses and velocities: the body whose moving frame they are
%                           expressed in; unless set: the world frame.
%
%   Limits of a sense or motor: mimo_scene_add(scene, 'limits', ...), or 'motor_limits':
%     delay                 Delay in seconds, 0 to 2, rounded to time steps of the model (at most 2000; independent of
%                           frame_skip) or, with attached senses, to steps. Default 0.
%     gain                  Factor of all values, 0 to 3.4e38 (the largest float). Default 1.
%     noise                 Standard deviation of the Gaussian noise that is added, 0 to 3.4e38, in the field's or
%                           action's unit (colours: levels of 255). Default 0.
%     blur                  For colour pictures only: lines of this many cycles per degree keep half their contrast,
%                           0.05 to 1000; 0 (default): sharp.
%     signal_noise          Standard deviation of further noise as a share of the value, 0 to 1000. Default 0.
%
%   Eyes and nerves: mimo_scene_add(scene, 'maturity', ...):
%     contrast_threshold    1: contrasts below the threshold disappear; 0 (default): they stay. Needs an acuity.
%     acuity                The finest visible lines, cycles per degree, 0.05 to 1000; 0 (default): pictures as drawn.
%     peak_contrast         Peak contrast sensitivity, 1.01 to 1000: at the acuity limit 1/peak_contrast of the contrast
%                           is left. Default 2. Needs an acuity.
%     chroma                Visible share of colour, 0 (grey) to 1 (default).
%     flicker               Cut-off frequency of a low-pass filter over the sensed pictures, Hz, 0.01 to 1000. 0
%                           (default): no filter.
%     conduction_speed      Of large nerve fibres, m/s, 0.1 to 200; 0 (default): no delay.
%     sensory_delay         From the brain stem to the cortex, s, 0 to 2.
%     motor_delay           From the cortex to the brain stem, s, 0 to 2.
%     vision_delay          From the eye to the cortex, s, 0 to 2.
%     vestibular_delay      From the inner ear to the brain stem, s, 0 to 2.
%     hearing_delay         From the ear to the cortex, s, 0 to 2.
%
%   A picture: the struct that mimo_picture takes for a camera:
%     camera                A camera of the model; unless set: the free camera below.
%     look_at               Free camera: the point in the middle, world, m.
%     distance              Free camera: its distance from that point, m, > 0.
%     azimuth               Free camera: degrees; 0 looks along +x, 90 along +y.
%     elevation             Free camera: degrees; negative looks down.
%     fovy                  Vertical field of view, degrees, 1 to 170; 0: the camera's own, for the free camera the
%                           model's.
%     foveation             As vision_foveation of mimo_agent_config, for colour and projected points. Default 0.
%
%   A recording: mimo_record:
%     compression           0 for none to 9 for the smallest file. Default 4.
%     keep                  Fields to keep of each step: "all", "none", or senses and fields with commas between them,
%                           "touch,vision/eye_left". Unless set: proprioception and vestibular of whoever has them.
%     state_seconds         Simulated seconds between states that are kept, 0.001 to 1e6. Default 1.
%     flush_seconds         Real seconds after which all is on its way to the disk, 0 to 1e6; 0: each step. Default 1.
%     configuration         What the program wants to find again: a text, best JSON. Unless set: "".
%     seed                  For people: the attribute `seed`. Replays do not need it. Default 0.
%     hdf5                  Path of the HDF5 library; unless set: see above.
%     replace               1: a whole recording that is there, and that no program is using, is replaced. 0 (default):
%                           it stays, and the recorder is refused.
%
%   What a stage is in: the struct that mimo_stage takes for its air:
%     headlight             1: the camera carries a light. Default 1.
%     near_plane            m, > 0: nothing nearer is drawn. Default .01.
%     far_plane             m, > near_plane: nothing farther is drawn. Default 50.
%     fog_start             m: where fog begins. Default 3.
%     fog_end               m: where nothing else is seen. Default 10.
%     haze                  Height of the haze at the horizon, a share of the sky, 0 to 1. Default .3.
%     fog_color             Red, green, blue. Default black.
%     haze_color            Likewise. Default white.
%     ambient               Of the headlight. Default .1.
%     diffuse               Likewise. Default .4.
%     specular              Likewise. Default .5.
%     sun_reach             m: lights of parallel rays let things cast shadows that are in front of their position and
%                           no farther from their axis, to each side, as the shadow maps of MuJoCo's OpenGL do; 0
%                           (default): all things.
%
%   A picture of a stage: the struct that mimo_stage_draw takes for a view:
%     height                Pixels, 1 to 16384. Default 240.
%     width                 Pixels, 1 to 16384. Default 320.
%     render                Words of Render. Default: all but fog.
%     samples               Rays per pixel of colours: 1, 4, 16 or 64; 0 (default): 1. Depth and segmentation are those
%                           of the middle of the pixel.
%     geom_groups           Bit n: geoms of group n are shown. Default 0x7: groups 0, 1 and 2.
%     site_groups           Likewise. Default 0x7.
%     surface_groups        Likewise. Default 0x7.
%     tendon_groups         Likewise. Default 0x7.
%     fovy                  Vertical field of view, degrees, > 0 and < 180. Default 45.
%     focal_x               Focal length along x, pixels, > 0; 0 (default): fovy counts.
%     focal_y               Likewise along y.
%     center_x              With focal lengths: the principal point, pixels from the left edge.
%     center_y              Likewise from the upper edge.
%     ortho_height          m, > 0: an orthographic camera, which sees so much from the lower edge to the upper one;
%                           fovy does not count then, and focal lengths are 0. 0 (default): a perspective.
%
%   Words of Place: Which point of an infant lies at its position.
%     'scene'               The scene's own place for an infant.
%     'root'                The origin of its root body mimo_location; standing soles are 0.33 m below.
%     'soles'               The point between its feet, at the height of their lowest point.
%     'lowest'              Below its root body, at the height of its lowest point: it lies on that height.
%
%   Words of Proprioception, which combine: What an agent feels of its joints and muscles.
%     'velocity'            Joint velocities, rad/s.
%     'torque'              Three-axis torque sensors at the joints, Nm.
%     'limit'               Limit sensors, 1 at a joint's limit.
%     'actuation'           Controls and torques of motors, targets, or the state of muscles.
%     'joint_torque'        Torque about each joint's own axis, Nm.
%     'position'            Joint angles, rad.
%     'effort'              proprioception/effort, 0 to 1: see docs/guide/muscles.md.
%     'all'                 All bits of the loaded library.
%     'spindle_primary'     Firing rates of receptors in muscles and joints, Hz: see docs/guide/proprioception.md. Off
%                           by default. proprioception/spindle_primary, two muscles per motor: Ia. Experimental.
%     'spindle_secondary'   proprioception/spindle_secondary, the same shape: II. Experimental.
%     'tendon_organ'        proprioception/tendon_organ, the same shape: Ib. Experimental.
%     'joint_receptor'      proprioception/joint_receptor, joints x 2: near its ends. Experimental.
%
%   Words of Vestibular, which combine: What the sense of balance reports.
%     'acceleration'        vestibular/acceleration, 3, m/s^2, gravity included.
%     'angular_velocity'    vestibular/angular_velocity, 3, rad/s.
%     'canals'              vestibular/canals, 6 x 2, Hz: see docs/guide/balance.md. Experimental.
%     'otoliths'            vestibular/otoliths, 2 x 2 x 2 x 2, Hz: see docs/guide/balance.md. Experimental.
%     'gravity'             vestibular/gravity, 3, m/s^2: the estimated direction of up. Experimental.
%
%   Words of Vision, which combine: What both eyes see.
%     'rgb'                 Colour, uint8 H x W x 3, row 0 is the top.
%     'depth'               Depth along the camera's axis, float32 H x W, metres.
%     'segmentation'        Geom id of each pixel, int32 H x W, -1 is background.
%
%   Words of Actuation: What an agent's actions are.
%     'torque'              An action is the share of a motor's largest torque.
%     'position'            An action is the angle to which a soft lock moves a joint, rad.
%     'muscle'              Two muscles per motor, by the original MIMo's model. Actions are the muscles' target
%                           activations, 0 to 1: first all muscles that pull to the negative side, "act:.../negative",
%                           then all that pull to the positive side. Joints lose their springs and 19/20 of their
%                           dampers, motors their limits. Before every physics step the muscles move their activation
%                           towards the action and pull. The motor's control input is then torque over gear; a world's
%                           own gear makes the muscles stronger or weaker. While a task prepares an episode, muscles do
%                           not pull. The motors need user numbers, see models/README.md. Fields, one number per muscle,
%                           at the end of the step: proprioception/activation, and proprioception/muscle_force, the
%                           force with which it would pull now.
%     'mujoco_muscle'       MuJoCo's muscle model: activation rises in 0.01 s, falls in 0.04 s.
%
%   Words of Act, which combine: Parts of the body that have motors.
%     'trunk'               Three motors.
%     'head'                Three motors.
%     'eyes'                Three motors per eye.
%     'right_arm'           Shoulder (three) and elbow.
%     'left_arm'            The same on the left.
%     'right_hand'          Wrist (three) and fingers: one motor of a mitten, 22 of five fingers.
%     'left_hand'           The same on the left.
%     'right_leg'           Hip (three) and knee.
%     'left_leg'            The same on the left.
%     'right_foot'          Ankle (three) and toes; a big toe has its own motor.
%     'left_foot'           The same on the left.
%     'all'                 All bits of the loaded library.
%     'none'                No motor; excludes the other bits.
%
%   Words of Touch, which combine: What the skin feels.
%     'force'               touch/force, N x 3: normal force and friction, N.
%     'normal_force'        touch/force, N x 1: only the normal force, N; instead of 'force'.
%     'slip'                touch/slip, N x 2: sliding over the skin, along its tangents, m/s.
%     'friction_use'        touch/friction_use, N x 1: share of the possible friction in use, 0 to 1.
%     'sa1'                 Receptors of the skin, N per field: see docs/guide/skin.md. In Hz unless stated otherwise;
%                           off by default. touch/sa1: depth of indentation. Experimental.
%     'ra'                  touch/ra: speed of indentation, and sliding. Experimental.
%     'pc'                  touch/pc: jolts and vibration, as an envelope. Experimental.
%     'sa2'                 touch/sa2, N x 2: stretch along the sensor's two tangents. Experimental.
%     'temperature'         touch/temperature: of the skin's surface, degrees Celsius. Experimental.
%     'cold'                touch/cold. Experimental.
%     'warm'                touch/warm. Experimental.
%     'nociception_fast'    touch/nociception_fast: pricks and heat, at once. Experimental.
%     'nociception_slow'    touch/nociception_slow: pricks, heat and cold, late and lasting. Experimental.
%     'units'               touch/units, N x 4: number of 'sa1', 'ra', 'pc', 'sa2' units per sensor. Experimental.
%     'ct'                  touch/ct: how hairy skin is stroked, at most 100. Experimental.
%
%   Words of TouchResponse: Which touch sensors feel how much of a contact.
%     'nearest'             The nearest sensor feels the whole touch.
%     'linear'              Weights fall linearly with the distance along the skin, to 0 at 2 spacings.
%     'gaussian'            Gaussian weights with a deviation of 2/3 spacing, cut off at 2 spacings.
%
%   Words of TouchFrame: The frame of reference of touch forces with three components.
%     'body'                The frame of the sensor's body.
%     'world'               The world frame.
%     'skin'                The skin's frame at the sensor: normal and two tangents; see 'frame'.
%
%   Words of Reflex, which combine: Reflexes of newborns, which add to the agent's commands.
%     'palmar_grasp'        Reflexes of newborns, added to the agent's commands according to its age: see
%                           docs/guide/reflexes.md. Fingers close on pressure on the palm; needs five fingers.
%                           Experimental.
%     'plantar_grasp'       Toes curl on pressure on the ball of the foot. Experimental.
%     'rooting'             The head turns towards a touch at a corner of the mouth. Experimental.
%     'moro'                The head drops: arms open, then close. Experimental.
%     'asymmetric_tonic_neck'The head turns: limbs stretch on that side, bend on the other. Experimental.
%     'stepping'            Upright on its feet, leaning forward: legs step in turn. Experimental.
%     'withdrawal'          Legs draw back from a touch or a prick. Experimental.
%     'felt'                reflex/activation has all reflexes that this body can show. Experimental.
%     'all'                 All reflexes of the loaded library that this body can show. Experimental.
%
%   Words of Hearing, which combine: What both ears hear.
%     'ears'                hearing/ear_left, hearing/ear_right: sound of the step at both ears, Pa. Experimental.
%     'bands'               hearing/bands, 2 x 24, dB above threshold; hearing/time_difference, s. Experimental.
%
%   Words of Sex: Whose growth an infant follows.
%     'mean'                The mean of the medians of girls and boys.
%     'female'              A girl.
%     'male'                A boy.
%
%   Words of GrowthModel: By which rules infants grow.
%     'who'                 The 'who''s child growth standards and measured infants: docs/guide/growth.md. Experimental.
%     'original'            The rules of MIMo's second version, for comparison. Experimental.
%
%   Words of Mature, which combine: What of an infant is as old as the infant.
%     'body'                Size, mass, strength and joints. 0 means this bit. Experimental.
%     'eyes'                Its eyes' acuity and colour, by its physiological age: mimo_maturity_at. Experimental.
%     'delays'              The delays of its nerves to and from the brain, by its physiological age. Experimental.
%     'threshold'           With 'eyes': contrasts below the threshold disappear. Experimental.
%     'flicker'             With 'eyes': changes above the flicker limit are blurred. Experimental.
%     'all'                 All bits of the loaded library except 'threshold' and 'flicker'. Experimental.
%
%   Words of Jacobian: How constraints are solved: the same solution to rounding.
%     'model'               The model's setting; built-in scenes use sparse. Experimental.
%     'dense'               The original's solver, for comparing trajectories to the last digit. Experimental.
%     'sparse'              The same solution up to rounding, about twice as fast. Experimental.
%
%   Words of Disable, which combine: Parts of physics to leave out.
%     'contact'             No contacts.
%     'gravity'             No gravity.
%     'own_solver'          MuJoCo's mj_step in place of libmimo's solver: same up to rounding, slower. Experimental.
%
%   Words of Render, which combine: What pictures show; what is left out costs nothing.
%     'shadows'             Lights cast shadows. Experimental.
%     'reflections'         Floors and boxes may mirror the scene. Experimental.
%     'sky'                 The scene's sky; without it the background is black. Experimental.
%     'haze'                Haze at the horizon of an endless floor. Experimental.
%     'fog'                 Fog, as the scene's MJCF describes it. Experimental.
%
%   Words of Autoreset: What a batch does when an episode ends.
%     'none'                Worlds continue after the end of an episode, until mimo_reset.
%     'next_step'           The step after the end of an episode starts a new one instead of acting: its reward, flags,
%                           outcome and terms are 0, and its block is the reset's.
%     'same_step'           The step that ends an episode also starts the next one: reward and flags belong to the old
%                           episode, the block is the first of the new one, and the last block of the old one goes to
%                           final_blocks.
%
%   Words of Shape: Shapes of objects, and what their size is.
%     'sphere'              size: radius.
%     'capsule'             size: radius, half length of the cylindrical part (along z).
%     'ellipsoid'           size: three radii.
%     'cylinder'            size: radius, half length (along z).
%     'box'                 size: three half lengths.
help mimo_options
end
% Generated by interface/generate.py from include/mimo; do not edit.
