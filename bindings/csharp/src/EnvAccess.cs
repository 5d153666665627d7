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
        Sensor = 7
    }

    /// <summary>Quantities to read and, where it says so, to write; how many numbers each has. Values are those of
    /// mimo.h.</summary>
    public enum Quantity
    {
        /// <summary>1 (hinge, rad; slide, m), 4 (ball, quaternion) or 7 (free). Writable.</summary>
        JointPosition = 1,
        /// <summary>1, 3 or 6. Writable.</summary>
        JointVelocity = 2,
        /// <summary>1, 3 or 6; generalised force applied by you until changed. Writable.</summary>
        JointForce = 3,
        /// <summary>1, 3 or 6.</summary>
        JointAcceleration = 4,
        /// <summary>2, low and high; infinite when not limited.</summary>
        JointRange = 5,
        /// <summary>3, of its frame's origin, world, m. Writable for bodies with a free joint.</summary>
        BodyPosition = 6,
        /// <summary>4, w x y z. Writable for bodies with a free joint.</summary>
        BodyOrientation = 7,
        /// <summary>6, linear (m/s) of its origin and angular (rad/s), world frame.</summary>
        BodyVelocity = 8,
        /// <summary>6, force (N) and torque (Nm) at its centre of mass, world frame, applied by you until changed.
        /// Writable.</summary>
        BodyForce = 9,
        /// <summary>1, kg.</summary>
        BodyMass = 10,
        /// <summary>3, of the body alone, world, m.</summary>
        BodyCenterOfMass = 11,
        /// <summary>3, world, m.</summary>
        GeomPosition = 12,
        /// <summary>4, w x y z.</summary>
        GeomOrientation = 13,
        /// <summary>3, by shape.</summary>
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
        ActuatorGear = 22
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

    /// <summary>Named access: look ids up once, then read and write many at a time.</summary>
    public sealed partial class Env
    {
        /// <summary>How many of a kind there are; their ids are 0 to one less.</summary>
        public int Count(Kind kind)
        {
            UIntPtr count;
            MimoException.Check(Native.mimo_env_count(handle, (int)kind, out count));
            return (int)count;
        }

        /// <summary>Id of something by its name in the model.</summary>
        public int Find(Kind kind, string name)
        {
            int id;
            MimoException.Check(Native.mimo_env_find(handle, (int)kind, Utf8.Bytes(name), out id));
            return id;
        }

        /// <summary>The body that a joint, geom, site or camera belongs to, or the parent of a body.</summary>
        public int BodyOf(Kind kind, int id)
        {
            int body;
            MimoException.Check(Native.mimo_env_body_of(handle, (int)kind, id, out body));
            return body;
        }

        /// <summary>Name of something; "" where the model gives none.</summary>
        public string Name(Kind kind, int id)
        {
            IntPtr name;
            MimoException.Check(Native.mimo_env_name(handle, (int)kind, id, out name));
            return Utf8.Of(name);
        }

        /// <summary>Reads a quantity of many at once; values is as long as all of them together need.</summary>
        public void Get(Quantity quantity, int[] ids, double[] values)
        {
            MimoException.Check(Native.mimo_env_get(handle, (int)quantity, ids, (UIntPtr)ids.Length, values, (UIntPtr)values.Length));
        }

        /// <summary>Writes a quantity of many at once.</summary>
        public void Set(Quantity quantity, int[] ids, double[] values)
        {
            MimoException.Check(Native.mimo_env_set(handle, (int)quantity, ids, (UIntPtr)ids.Length, values, (UIntPtr)values.Length));
        }

        /// <summary>How many values a quantity of these has together.</summary>
        public int Width(Quantity quantity, int[] ids)
        {
            UIntPtr count;
            MimoException.Check(Native.mimo_env_width(handle, (int)quantity, ids, (UIntPtr)ids.Length, out count));
            return (int)count;
        }

        /// <summary>Recomputes poses from the current joint positions. The trajectory stays as it was.</summary>
        public void Update() { MimoException.Check(Native.mimo_env_update(handle)); }

        /// <summary>The contacts that the last physics step computed, with their forces.</summary>
        public Contact[] Contacts()
        {
            const int idCount = 4, valueCount = 19; // MIMO_CONTACT_IDS, MIMO_CONTACT_VALUES
            UIntPtr count;
            MimoException.Check(Native.mimo_env_contacts(handle, null, null, UIntPtr.Zero, out count));
            var ids = new int[idCount * (int)count];
            var values = new double[valueCount * (int)count];
            MimoException.Check(Native.mimo_env_contacts(handle, ids, values, count, out count));
            var contacts = new Contact[(int)count];
            for (var i = 0; i < contacts.Length; ++i) contacts[i] = ContactOf(ids, idCount * i, values, valueCount * i);
            return contacts;
        }

        /// <summary>Of an entry: position 3, frame 9 (rows: normal, two tangents), distance, force in that frame 3, torque 3.</summary>
        private static Contact ContactOf(int[] ids, int id, double[] values, int at)
        {
            Func<int, Vector3d> three = i => new Vector3d(values[at + i], values[at + i + 1], values[at + i + 2]);
            Func<int, double> world = axis => values[at + 13] * values[at + 3 + axis] +
                values[at + 14] * values[at + 6 + axis] + values[at + 15] * values[at + 9 + axis];
            return new Contact
            {
                Geom1 = ids[id], Geom2 = ids[id + 1], Body1 = ids[id + 2], Body2 = ids[id + 3],
                Position = three(0), Normal = three(3), Distance = values[at + 12],
                Force = new Vector3d(world(0), world(1), world(2))
            };
        }

        /// <summary>Whether an agent's last step was a success or a failure, also where that does not end the episode.</summary>
        public void Outcome(int agent, out bool success, out bool failure)
        {
            byte good, bad;
            MimoException.Check(Native.mimo_env_outcome(handle, (UIntPtr)agent, out good, out bad));
            success = good != 0;
            failure = bad != 0;
        }
    }
}
