using System;

namespace Mimo
{
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
        /// <summary>Position in the world, m.</summary>
        public Vector3d Position;
        /// <summary>Unit vector from geom 1 to geom 2, world frame.</summary>
        public Vector3d Normal;
        /// <summary>Distance in metres; negative if the geoms overlap.</summary>
        public double Distance;
        /// <summary>Force on body 2, N, world frame.</summary>
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
        /// <summary>Time of the first touch, seconds since the step's start.</summary>
        public double Start;
        /// <summary>Time of the last touch, seconds since the step's start.</summary>
        public double End;
        /// <summary>Impulse on body 2 over the whole step, N s.</summary>
        public Vector3d Impulse;
        /// <summary>Largest force on body 2 in a physics step, N.</summary>
        public Vector3d PeakForce;
        /// <summary>Position of the strongest contact at that time, m.</summary>
        public Vector3d PeakPosition;
    }

    /// <summary>Named access: find ids once, then read and write many values per call.</summary>
    public sealed partial class Env
    {
        /// <summary>Number of things of a kind. Their ids are 0 to Count - 1.</summary>
        public int Count(Kind kind)
        {
            UIntPtr count;
            MimoException.Check(Native.mimo_env_count(Handle, (int)kind, out count));
            return (int)count;
        }

        /// <summary>The id of a thing with that name in the model.</summary>
        public int Find(Kind kind, string name)
        {
            int id;
            MimoException.Check(Native.mimo_env_find(Handle, (int)kind, Utf8.Bytes(name), out id));
            return id;
        }

        /// <summary>The body of a joint, geom, site, camera or light, or the parent of a body.</summary>
        public int BodyOf(Kind kind, int id)
        {
            int body;
            MimoException.Check(Native.mimo_env_body_of(Handle, (int)kind, id, out body));
            return body;
        }

        /// <summary>The name of a thing; "" if it has none in the model.</summary>
        public string Name(Kind kind, int id)
        {
            IntPtr name;
            MimoException.Check(Native.mimo_env_name(Handle, (int)kind, id, out name));
            return Utf8.Of(name);
        }

        /// <summary>Reads a quantity of several ids. values must have the length that Width returns. ids = null: all
        /// things of the quantity's kind.</summary>
        public void Get(Quantity quantity, int[] ids, double[] values)
        {
            MimoException.Check(Native.mimo_env_get(Handle, (int)quantity, ids, Given.LengthOrNone(ids), values, Given.LengthOf(values, "values")));
        }

        /// <summary>The same in single precision, for engines.</summary>
        public void Get(Quantity quantity, int[] ids, float[] values)
        {
            MimoException.Check(Native.mimo_env_get_float(Handle, (int)quantity, ids, Given.LengthOrNone(ids), values, Given.LengthOf(values, "values")));
        }

        /// <summary>Reads a quantity of all things of its kind.</summary>
        public double[] Get(Quantity quantity)
        {
            var values = new double[Width(quantity, null)];
            try
            {
                Get(quantity, null, values);
            }
            catch (MimoException) when (Width(quantity, null) != values.Length)
            {
                throw new MimoException(Status.Busy, "MIMO_E_BUSY", "another thread is using this Env: its contacts changed during the call");
            }
            return values;
        }

        /// <summary>Writes a quantity of several ids. ids = null: all things of the quantity's kind.</summary>
        public void Set(Quantity quantity, int[] ids, params double[] values)
        {
            MimoException.Check(Native.mimo_env_set(Handle, (int)quantity, ids, Given.LengthOrNone(ids), values, Given.LengthOf(values, "values")));
        }

        /// <summary>Number of values that a quantity of several ids has in total. ids = null: all things of the
        /// quantity's kind.</summary>
        public int Width(Quantity quantity, int[] ids)
        {
            UIntPtr count;
            MimoException.Check(Native.mimo_env_width(Handle, (int)quantity, ids, Given.LengthOrNone(ids), out count));
            return (int)count;
        }

        /// <summary>Recomputes all poses from the current joint positions. The trajectory does not change.</summary>
        public void Update() { MimoException.Check(Native.mimo_env_update(Handle)); }

        /// <summary>The contacts of the last physics step, with their forces.</summary>
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

        /// <summary>The pairs of geoms that touched during the last step, in worlds with
        /// EnvConfig.StepContacts.</summary>
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

        /// <summary>Fills an array with random numbers from 0 (inclusive) to 1 (exclusive), drawn from the world's
        /// random stream.</summary>
        public void Random(double[] values)
        {
            MimoException.Check(Native.mimo_env_random(Handle, values, Given.LengthOf(values, "values")));
        }
    }
}
