using System;

namespace Mimo
{
    /// <summary>Kinds of named things; values are those of mimo.h.</summary>
    public enum Kind
    {
        /// <summary>Rigid bodies; 0 is the world.</summary>
        Body = 1,
        /// <summary>Joints: hinges, slides, balls, free joints.</summary>
        Joint = 2,
        /// <summary>Shapes of bodies.</summary>
        Geom = 3,
        /// <summary>Marked places on bodies.</summary>
        Site = 4,
        /// <summary>Cameras.</summary>
        Camera = 5,
        /// <summary>Motors.</summary>
        Actuator = 6,
        /// <summary>MuJoCo's sensors.</summary>
        Sensor = 7,
        /// <summary>Lights.</summary>
        Light = 8,
        /// <summary>Contacts that the last physics step computed.</summary>
        Contact = 9,
        /// <summary>Pairs of geoms that touched during the last step, in worlds with EnvOptions.StepContacts.</summary>
        StepContact = 10,
        /// <summary>Infants, by their index.</summary>
        Agent = 11,
        /// <summary>Faces that the model has.</summary>
        Face = 12,
        /// <summary>The world itself, 0.</summary>
        World = 13,
        /// <summary>Kinds of warnings; their ids are those of the enumeration Warning.</summary>
        Warning = 14
    }

    /// <summary>Quantities to read and, where it says so, to write; how many numbers each has. Values are those of
    /// mimo.h.</summary>
    public enum Quantity
    {
        /// <summary>1 (hinge, rad; slide, m), 4 (ball, quaternion) or 7 (free). Writable.</summary>
        JointPosition = 1,
        /// <summary>1, 3 or 6. Writable.</summary>
        JointVelocity = 2,
        /// <summary>1, 3 or 6; generalised force that you apply, until you change it or the world is reset. Writable.</summary>
        JointForce = 3,
        /// <summary>1, 3 or 6.</summary>
        JointAcceleration = 4,
        /// <summary>2, low and high; infinite when not limited.</summary>
        JointRange = 5,
        /// <summary>3, of its frame's origin, world, m. Writable with a free joint, or where it stands fixed.</summary>
        BodyPosition = 6,
        /// <summary>4, w x y z. Writable with a free joint, or where it stands fixed.</summary>
        BodyOrientation = 7,
        /// <summary>6, linear (m/s) of its origin and angular (rad/s), world frame.</summary>
        BodyVelocity = 8,
        /// <summary>6, force (N) and torque (Nm) at its centre of mass, world frame, as JointForce.
        /// Writable.</summary>
        BodyForce = 9,
        /// <summary>1, kg. Writable; inertia grows along. Outlives resets.</summary>
        BodyMass = 10,
        /// <summary>3, of the body alone, world, m.</summary>
        BodyCenterOfMass = 11,
        /// <summary>3, world, m.</summary>
        GeomPosition = 12,
        /// <summary>4, w x y z.</summary>
        GeomOrientation = 13,
        /// <summary>3, by shape. Writable; outlives resets.</summary>
        GeomSize = 14,
        /// <summary>3, world, m.</summary>
        SitePosition = 15,
        /// <summary>4, w x y z.</summary>
        SiteOrientation = 16,
        /// <summary>3, world, m.</summary>
        CameraPosition = 17,
        /// <summary>4, w x y z; a camera looks along its -z, +y is up in the picture.</summary>
        CameraOrientation = 18,
        /// <summary>1, control input. Writable.</summary>
        ActuatorControl = 19,
        /// <summary>1, N or Nm.</summary>
        ActuatorForce = 20,
        /// <summary>Its dimension.</summary>
        SensorValue = 21,
        /// <summary>1, torque at control input 1, Nm; in this world only, outlives resets. Writable.</summary>
        ActuatorGear = 22,
        /// <summary>7, position and orientation. Writable as they are.</summary>
        BodyPose = 23,
        /// <summary>7, position and orientation.</summary>
        GeomPose = 24,
        /// <summary>7, position and orientation.</summary>
        SitePose = 25,
        /// <summary>7, position and orientation.</summary>
        CameraPose = 26,
        /// <summary>3, sliding, torsional, rolling. Writable; outlives resets.</summary>
        GeomFriction = 27,
        /// <summary>4, red, green, blue, opacity, 0 to 1. Writable; outlives resets.</summary>
        GeomColor = 28,
        /// <summary>1. Writable; outlives resets.</summary>
        JointDamping = 29,
        /// <summary>2, 1 where it is held, else 0; and the angle, rad. Writable; outlives resets.</summary>
        JointLock = 30,
        /// <summary>3, m, in the frame of its body. Writable; outlives resets.</summary>
        LightPosition = 31,
        /// <summary>3, unit vector in that frame. Writable; outlives resets.</summary>
        LightDirection = 32,
        /// <summary>3, red, green, blue. Writable; outlives resets.</summary>
        LightColor = 33,
        /// <summary>2, ids.</summary>
        ContactGeoms = 34,
        /// <summary>2, ids.</summary>
        ContactBodies = 35,
        /// <summary>3, world, m.</summary>
        ContactPosition = 36,
        /// <summary>9, rows: normal from geom 1 to geom 2, two tangents; world.</summary>
        ContactFrame = 37,
        /// <summary>1, m; negative: overlap.</summary>
        ContactDistance = 38,
        /// <summary>3, on the second body, in the contact's frame, N.</summary>
        ContactForce = 39,
        /// <summary>3, on the second body, in the contact's frame, Nm.</summary>
        ContactTorque = 40,
        /// <summary>2, ids.</summary>
        StepContactGeoms = 41,
        /// <summary>2, ids.</summary>
        StepContactBodies = 42,
        /// <summary>1, s since the step began.</summary>
        StepContactStart = 43,
        /// <summary>1, s since the step began.</summary>
        StepContactEnd = 44,
        /// <summary>3, on the second body, world, N s.</summary>
        StepContactImpulse = 45,
        /// <summary>3, on the second body, world, N.</summary>
        StepContactPeakForce = 46,
        /// <summary>3, world, m.</summary>
        StepContactPeakPosition = 47,
        /// <summary>1, id of the face; -1 for none. Writable; outlives resets.</summary>
        AgentFace = 48,
        /// <summary>3, m/s^2, world frame. Writable; outlives resets.</summary>
        WorldGravity = 49,
        /// <summary>1, how many physics steps had it since the world was made. Writable with 0.</summary>
        WarningCount = 50,
        /// <summary>6, linear (m/s) of its position and angular (rad/s), world frame.</summary>
        SiteVelocity = 51,
        /// <summary>What its task wants of an agent; how many numbers depends on the task.</summary>
        AgentGoal = 52,
        /// <summary>What is so far of its goal.</summary>
        AgentAchieved = 53,
        /// <summary>How old an infant is, months.</summary>
        AgentAge = 54,
        /// <summary>The same of its strength, range of motion and tone.</summary>
        AgentPhysiologicalAge = 55,
        /// <summary>1, m, how long the nerves are from this part of an infant to its head; 0 for what is no part of one.</summary>
        BodyNerveLength = 56,
        /// <summary>Actuator: 4, dynamic and static drive of its two muscles' spindles, Hz, until changed or reset.
        /// Writable.</summary>
        ActuatorFusimotorDrive = 57,
        /// <summary>Or-ed to a quantity: its value of now, which follows from the current positions.</summary>
        Now = 0x40000000
    }

    /// <summary>Two geoms that touch.</summary>
    public struct Contact
    {
        /// <summary>Geom 1.</summary>
        public int Geom1;
        /// <summary>Geom 2.</summary>
        public int Geom2;
        /// <summary>Body of geom 1.</summary>
        public int Body1;
        /// <summary>Body of geom 2.</summary>
        public int Body2;
        /// <summary>World, m.</summary>
        public Vector3d Position;
        /// <summary>From geom 1 to geom 2, world, unit vector.</summary>
        public Vector3d Normal;
        /// <summary>Metres; negative: overlap.</summary>
        public double Distance;
        /// <summary>On body 2, world, N.</summary>
        public Vector3d Force;
    }

    /// <summary>Two geoms that touched during a step; world frame.</summary>
    public struct StepContact
    {
        /// <summary>Geom 1.</summary>
        public int Geom1;
        /// <summary>Geom 2.</summary>
        public int Geom2;
        /// <summary>Body of geom 1.</summary>
        public int Body1;
        /// <summary>Body of geom 2.</summary>
        public int Body2;
        /// <summary>When they first touched, seconds since the step began.</summary>
        public double Start;
        /// <summary>When they last touched, seconds since the step began.</summary>
        public double End;
        /// <summary>On body 2 over the whole step, N s.</summary>
        public Vector3d Impulse;
        /// <summary>On body 2, the largest of the physics steps', N.</summary>
        public Vector3d PeakForce;
        /// <summary>Of the strongest contact then, m.</summary>
        public Vector3d PeakPosition;
    }

    /// <summary>Named access: look ids up once, then read and write many at a time.</summary>
    public sealed partial class Env
    {
        /// <summary>How many of a kind there are; their ids are 0 to one less.</summary>
        public int Count(Kind kind)
        {
            UIntPtr count;
            MimoException.Check(Native.mimo_env_count(Handle, (int)kind, out count));
            return (int)count;
        }

        /// <summary>Id of something by its name in the model.</summary>
        public int Find(Kind kind, string name)
        {
            int id;
            MimoException.Check(Native.mimo_env_find(Handle, (int)kind, Utf8.Bytes(name), out id));
            return id;
        }

        /// <summary>The body that a joint, geom, site or camera belongs to, or the parent of a body.</summary>
        public int BodyOf(Kind kind, int id)
        {
            int body;
            MimoException.Check(Native.mimo_env_body_of(Handle, (int)kind, id, out body));
            return body;
        }

        /// <summary>Name of something; "" where the model gives none.</summary>
        public string Name(Kind kind, int id)
        {
            IntPtr name;
            MimoException.Check(Native.mimo_env_name(Handle, (int)kind, id, out name));
            return Utf8.Of(name);
        }

        /// <summary>Reads a quantity of many at once; values is as long as all of them together need. Ids null: all of its
        /// kind.</summary>
        public void Get(Quantity quantity, int[] ids, double[] values)
        {
            MimoException.Check(Native.mimo_env_get(Handle, (int)quantity, ids, Given.LengthOrNone(ids), values, Given.LengthOf(values, "values")));
        }

        /// <summary>The same in single precision, for engines.</summary>
        public void Get(Quantity quantity, int[] ids, float[] values)
        {
            MimoException.Check(Native.mimo_env_get_float(Handle, (int)quantity, ids, Given.LengthOrNone(ids), values, Given.LengthOf(values, "values")));
        }

        /// <summary>Reads a quantity of all of its kind.</summary>
        public double[] Get(Quantity quantity)
        {
            var values = new double[Width(quantity, null)];
            try
            {
                Get(quantity, null, values);
            }
            catch (MimoException) when (Width(quantity, null) != values.Length)
            {
                throw new MimoException(Status.Busy, "MIMO_E_BUSY", "another thread is using this Env: its contacts changed while they were read");
            }
            return values;
        }

        /// <summary>Writes a quantity of many at once. Ids null: all of its kind.</summary>
        public void Set(Quantity quantity, int[] ids, params double[] values)
        {
            MimoException.Check(Native.mimo_env_set(Handle, (int)quantity, ids, Given.LengthOrNone(ids), values, Given.LengthOf(values, "values")));
        }

        /// <summary>How many values a quantity of these has together. Ids null: all of its kind.</summary>
        public int Width(Quantity quantity, int[] ids)
        {
            UIntPtr count;
            MimoException.Check(Native.mimo_env_width(Handle, (int)quantity, ids, Given.LengthOrNone(ids), out count));
            return (int)count;
        }

        /// <summary>Recomputes poses from the current joint positions. The trajectory stays as it was.</summary>
        public void Update() { MimoException.Check(Native.mimo_env_update(Handle)); }

        /// <summary>The contacts that the last physics step computed, with their forces.</summary>
        public Contact[] Contacts()
        {
            double[] geoms = Get(Quantity.ContactGeoms), bodies = Get(Quantity.ContactBodies),
                places = Get(Quantity.ContactPosition), frames = Get(Quantity.ContactFrame),
                distances = Get(Quantity.ContactDistance), forces = Get(Quantity.ContactForce);
            var contacts = new Contact[distances.Length];
            for (var i = 0; i < contacts.Length; ++i)
            {
                Vector3d normal = VectorOf(frames, 3 * i), one = VectorOf(frames, 3 * i + 1), two = VectorOf(frames, 3 * i + 2),
                    force = VectorOf(forces, i);
                contacts[i] = new Contact
                {
                    Geom1 = (int)geoms[2 * i], Geom2 = (int)geoms[2 * i + 1], Body1 = (int)bodies[2 * i],
                    Body2 = (int)bodies[2 * i + 1], Position = VectorOf(places, i), Normal = normal, Distance = distances[i],
                    Force = new Vector3d(force.X * normal.X + force.Y * one.X + force.Z * two.X,
                        force.X * normal.Y + force.Y * one.Y + force.Z * two.Y,
                        force.X * normal.Z + force.Y * one.Z + force.Z * two.Z)
                };
            }
            return contacts;
        }

        /// <summary>What touched what during the last step, in worlds with EnvOptions.StepContacts.</summary>
        public StepContact[] StepContacts()
        {
            double[] geoms = Get(Quantity.StepContactGeoms), bodies = Get(Quantity.StepContactBodies),
                starts = Get(Quantity.StepContactStart), ends = Get(Quantity.StepContactEnd),
                impulses = Get(Quantity.StepContactImpulse), forces = Get(Quantity.StepContactPeakForce),
                places = Get(Quantity.StepContactPeakPosition);
            var contacts = new StepContact[starts.Length];
            for (var i = 0; i < contacts.Length; ++i)
            {
                contacts[i] = new StepContact
                {
                    Geom1 = (int)geoms[2 * i], Geom2 = (int)geoms[2 * i + 1], Body1 = (int)bodies[2 * i],
                    Body2 = (int)bodies[2 * i + 1], Start = starts[i], End = ends[i], Impulse = VectorOf(impulses, i),
                    PeakForce = VectorOf(forces, i), PeakPosition = VectorOf(places, i)
                };
            }
            return contacts;
        }

        private static Vector3d VectorOf(double[] values, int i)
        {
            return new Vector3d(values[3 * i], values[3 * i + 1], values[3 * i + 2]);
        }

        /// <summary>Fills an array with numbers from 0 (inclusive) to 1 (exclusive) from the world's own random stream.</summary>
        public void Random(double[] values)
        {
            MimoException.Check(Native.mimo_env_random(Handle, values, Given.LengthOf(values, "values")));
        }
    }
}
