function mimo_quantities()
% MIMO_QUANTITIES  What mimo_get reads, and mimo_set writes where it is writable.
%   mimo_quantities() shows this page.
%   Each entry begins with the kind, and the number of values of each element. Poses and velocities belong to
%   the start of the last physics step; with _now after the name ('body_position_now') to the present. W: the
%   value belongs to the world and outlives resets. Experimental: docs/abi.md.
%
%     body_position               Body: 3, of its frame's origin, world, m. Writable with a free joint; W for one that
%                                 stands on the world without joints.
%     body_orientation            Body: 4, w x y z. Writable as 'body_position'.
%     body_velocity               Body: 6, linear (m/s) of its origin and angular (rad/s), world frame.
%     body_force                  Body: 6, force and torque at its centre of mass, world. Writable as 'joint_force'.
%     body_mass                   Body: 1, kg, > 0. Writable, W: its inertia grows along.
%     body_center_of_mass         Body: 3, of the body alone, world, m.
%     body_pose                   Body: 7, position and orientation. Writable as 'body_position'.
%     joint_position              Joint: 1 (hinge rad, slide m), 4 (ball, quaternion) or 7 (free). Writable.
%     joint_velocity              Joint: 1, 3 or 6. Writable.
%     joint_force                 Joint: 1, 3 or 6; generalised force that you apply, until you change it or the world
%                                 is reset. Writable.
%     joint_acceleration          Joint: 1, 3 or 6.
%     joint_range                 Joint: 2, low and high; -inf and inf when not limited.
%     joint_damping               Joint: 1, for all its axes, Nms/rad or Ns/m, >= 0. Writable, W.
%     joint_lock                  Joint: 2, 1 where it is held, else 0; and at which angle, rad. Writable, W, for hinges
%                                 of infants; see mimo_set. 0 and 0 where nothing could hold it.
%     geom_position               Geom: 3, world, m.
%     geom_orientation            Geom: 4, w x y z.
%     geom_size                   Geom: 3, by shape, m, > 0; those that its shape does not use are left alone. Writable,
%                                 W, but for planes, meshes and height fields: what touches and what is seen; mass,
%                                 inertia and touch sensors stay.
%     geom_pose                   Geom: 7, position and orientation.
%     geom_friction               Geom: 3, sliding, torsional (m), rolling (m), >= 0; two geoms meet with the larger
%                                 one, or as their pair in the model says. Writable, W.
%     geom_color                  Geom: 4, red, green, blue, opacity, 0 to 1. (0.5, 0.5, 0.5, 1) shows the material's
%                                 colour, where there is a material. Writable, W.
%     site_position               Site: 3, world, m.
%     site_orientation            Site: 4, w x y z.
%     site_pose                   Site: 7, position and orientation.
%     site_velocity               Site: 6, linear (m/s) of its position and angular (rad/s), world frame.
%     camera_position             Camera: 3, world, m.
%     camera_orientation          Camera: 4, w x y z; a camera looks along its -z, +y is up in the picture.
%     camera_pose                 Camera: 7, position and orientation.
%     actuator_control            Actuator: 1, control input. Writable.
%     actuator_force              Actuator: 1, N or Nm.
%     actuator_gear               Actuator: 1, Nm at control 1. Writable, W.
%     sensor_value                Sensor: its dimension.
%     light_position              Light: 3, m, in the frame of its body, mostly the world. Writable, W.
%     light_direction             Light: 3, unit vector in that frame. Writable (any length), W.
%     light_color                 Light: 3, red, green, blue of its diffuse part, 0 to 100. Writable, W.
%     contact_geoms               Contact: 2, ids of geom 1 and geom 2; -1 for a flex (MuJoCo 4).
%     contact_bodies              Contact: 2, ids of their bodies; of a flex that of the nearest vertex.
%     contact_position            Contact: 3, world, m.
%     contact_frame               Contact: 9, rows: normal from geom 1 to geom 2, two tangents; world.
%     contact_distance            Contact: 1, m; negative: how deep the geoms overlap, of boxes too.
%     contact_force               Contact: 3, on the second body, in the contact's frame, N.
%     contact_torque              Contact: 3, on the second body, in the contact's frame, Nm.
%     step_contact_geoms          Step contact: 2, ids of geom 1 and geom 2; -1 for a flex (MuJoCo 4).
%     step_contact_bodies         Step contact: 2, ids of their bodies.
%     step_contact_start          Step contact: 1, when they first touched, s since the step's start.
%     step_contact_end            Step contact: 1, when they last touched, s since the step's start.
%     step_contact_impulse        Step contact: 3, on the second body over the step, world, N s.
%     step_contact_peak_force     Step contact: 3, the largest of the physics steps' forces, on the second body, world,
%                                 N.
%     step_contact_peak_position  Step contact: 3, of the strongest contact at that time, world, m.
%     agent_face                  Agent: 1, id of the 'face' that it shows; -1 for none of them. Writable, W, for agents
%                                 that have a face.
%     agent_goal                  Agent: the numbers that its task wants to be reached; how many they are and what they
%                                 mean depends on the task, see docs/tasks.md. No numbers for a task without a goal and
%                                 for a custom task, which has fields instead.
%     agent_achieved              Agent: the same numbers as they are so far; see 'agent_goal'.
%     agent_age                   Agent: 1, its age in months, for size and mass (mimo_growth). No number for an agent
%                                 that is not an infant.
%     world_gravity               World: 3, m/s^2, world frame. Writable, W.
%     body_nerve_length           Body: 1, m, how long nerves are from the middle of this part of an infant to its head,
%                                 through the joints on their way; 0 for what is no part of one. Experimental.
%     body_inertial               Body: 9, what inertial sensors in the origin of its frame read, in that frame:
%                                 acceleration with gravity's (m/s^2; at rest 9.81 upwards, in free fall 0), angular
%                                 velocity (rad/s), angular acceleration (rad/s^2). With a, w and b for these, a sensor
%                                 at the point p of the body reads the acceleration a + b x p + w x (w x p). Physics
%                                 steps compute it. Experimental.
%     actuator_fusimotor_drive    Actuator: 4, what its two muscles' fusimotor neurons are told, Hz, 0 to 500: dynamic
%                                 and static of the one that pulls to the negative side, then of the other; until you
%                                 change it or the world is reset, 70 each. None where its agent senses no spindles,
%                                 'spindle_primary' or _SECONDARY. Writable. Experimental.
%     agent_physiological_age     Agent: 1, months, of strength, range of motion and tone; likewise. Experimental.
%     warning_steps               Warning: 1, how many physics steps had it since the world was made; resets and loaded
%                                 states leave it. Writable with 0, to count anew. Experimental.
help mimo_quantities
end
% Generated by interface/generate.py from include/mimo; do not edit.
