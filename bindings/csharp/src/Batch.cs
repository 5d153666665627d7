using System;
using System.Linq;

namespace Mimo
{
    /// <summary>Many worlds of one scene, stepped by a pool of threads. World i behaves exactly as a single world that
    /// is reset with the i-th seed and gets the i-th actions. All arrays are made once: a step allocates nothing. Masks
    /// have one entry per world; null selects all worlds.</summary>
    public sealed partial class Batch : IDisposable
    {
        private readonly BatchHandle owned;
        private BatchHandle Handle => Ending.Pass(owned);
        private readonly Env first;
        private readonly Results results;
        private readonly byte[] wasReset, finalWritten;
        private readonly IntPtr blocks;     // pinned
        private BatchResultsStruct places;

        /// <summary>Number of worlds.</summary>
        public int Worlds { get; }

        /// <summary>Number of threads that step the worlds.</summary>
        public int Threads { get; }

        /// <summary>The observations, actions and reward terms of each world.</summary>
        public Layout Layout { get; }

        /// <summary>The last observations, one world after the other. Each reset, step and observation overwrites
        /// them.</summary>
        public byte[] Blocks { get; }

        /// <summary>The last observations of ended episodes, for the worlds with HasFinal; null without
        /// Autoreset.SameStep.</summary>
        public byte[] FinalBlocks { get; }

        /// <summary>Rewards of the last step, worlds x agents.</summary>
        public double[] Rewards => results.Rewards;

        /// <summary>The terms of the rewards, worlds x terms, in the order of Layout.Terms.</summary>
        public double[] Terms => results.Terms;

        /// <summary>Compiles a scene once and makes worlds from it. threads = 0 uses all cores. With a cohort the
        /// infants of world i get the growth cohort[i % cohort.Length]; null keeps the scene's infants.</summary>
        public Batch(MimoScene scene, int worlds, EnvConfig config = null, Autoreset autoreset = Autoreset.None, int threads = 0,
            bool restartFailed = false, Growth[] cohort = null)
        {
            var raw = BatchConfigStruct.New();
            raw.worlds = Given.Count(worlds, "worlds");
            raw.threads = Given.Count(threads, "threads");
            raw.autoreset = (int)autoreset;
            raw.restart_failed = restartFailed ? 1u : 0u;
            using (var ages = new PinnedGrowths(cohort))
            {
                raw.cohort = ages.Pointer;
                raw.cohort_count = ages.Length;
                owned = Create(scene, config ?? new EnvConfig(), raw);
            }
            Ending.Watch(owned);
            UIntPtr worldCount, threadCount;
            MimoException.Check(Native.mimo_batch_size(Handle, out worldCount, out threadCount));
            Worlds = (int)worldCount;
            Threads = (int)threadCount;
            Layout = new Layout(Handle, (out IntPtr layout) => Native.mimo_batch_layout(Handle, out layout));
            first = World(0);
            Blocks = new byte[worlds * Layout.BlockBytes];
            blocks = Handle.Kept.Keep(Blocks);
            FinalBlocks = autoreset == Autoreset.SameStep ? new byte[Blocks.Length] : null;
            results = new Results(Layout, worlds);
            wasReset = new byte[worlds];
            finalWritten = new byte[worlds];
            places = Places();
        }

        private BatchResultsStruct Places()
        {
            var kept = Handle.Kept;
            var common = results.PlaceIn(kept);
            return new BatchResultsStruct
            {
                struct_size = BatchResultsStruct.Bytes, reward = common.reward, terminated = common.terminated,
                truncated = common.truncated, outcome = common.outcome, agent_count = common.agent_count, terms = common.terms,
                term_count = common.term_count, was_reset = kept.Keep(wasReset), final_written = kept.Keep(finalWritten),
                worlds = (UIntPtr)Worlds, final_blocks = kept.Keep(FinalBlocks),
                final_bytes = (UIntPtr)(FinalBlocks == null ? 0 : FinalBlocks.Length)
            };
        }

        private static BatchHandle Create(MimoScene scene, EnvConfig config, BatchConfigStruct raw)
        {
            return config.Use((env, log) =>
            {
                BatchHandle made;
                var status = Native.mimo_batch_create(Given.Some(scene, "scene", "a MimoScene").Handle, ref env, ref raw, out made);
                made.Log = log;
                Logging.CheckTold(status, log);
                made.Task = scene.Handle.Task?.Share();
                return made;
            });
        }

        /// <summary>One world, usable between the batch's own calls, for example for names, pictures and locks. Its
        /// block is separate from the batch's blocks.</summary>
        public Env World(int world)
        {
            IntPtr env;
            MimoException.Check(Native.mimo_batch_world(Handle, Given.Index(world, "world"), out env));
            return new Env(new EnvHandle(env, Handle), Layout);
        }

        /// <summary>Copies a field of one world's last observation into an array of its element type.</summary>
        public void Read<T>(int world, Field field, T[] into) where T : struct
        {
            Given.Some(field, "field", "one of Layout.Fields").CopyTo(into, Blocks, StartOf(world));
        }

        private int StartOf(int world)
        {
            return Given.Below(world, Worlds, "world") * Layout.BlockBytes;
        }

        /// <summary>Starts episodes. seeds has one seed per world; null: the worlds' random numbers continue. ages has
        /// one growth per world, for all its infants; null, also as an entry, keeps their age.</summary>
        public void Reset(ulong[] seeds = null, bool[] mask = null, Growth[] ages = null)
        {
            if (seeds != null && seeds.Length != Worlds)
                throw Given.Misfit(seeds, nameof(seeds), "expected one for each of " + Worlds + " worlds");
            if (ages != null && ages.Length != Worlds)
                throw Given.Misfit(ages, nameof(ages), "expected one for each of " + Worlds + " worlds");
            using (Pinned given = new Pinned(seeds), chosen = new Pinned(BytesOf(mask)))
            using (var growths = new PinnedGrowths(ages))
            {
                var config = new BatchResetConfigStruct
                {
                    struct_size = BatchResetConfigStruct.Bytes, seeds = given.Pointer, mask = chosen.Pointer,
                    worlds = mask != null ? chosen.Length : seeds != null ? given.Length : growths.Length,
                    growth = growths.Pointer
                };
                MimoException.Check(Native.mimo_batch_reset(Handle, ref config, Blocks, (UIntPtr)Blocks.Length));
            }
            if (ages != null) Layout.Renew();
        }

        /// <summary>Fills in what the motors of all infants do by themselves: actions for the next step, one world after the
        /// other.</summary>
        public void Spontaneous(float[] actions, Movement which = Movement.All)
        {
            MimoException.Check(Native.mimo_batch_spontaneous(Handle, (uint)which, actions, Given.LengthOf(actions, "actions")));
        }

        /// <summary>The error message of a world's last call; "" if it succeeded.</summary>
        public string ErrorOf(int world)
        {
            int status;
            IntPtr message;
            MimoException.Check(Native.mimo_batch_world_error(Handle, Given.Index(world, "world"), out status, out message));
            return Utf8.Of(message);
        }

        /// <summary>Observes the current states. The trajectories do not change.</summary>
        public void Observe(bool[] mask = null)
        {
            var chosen = BytesOf(mask);
            MimoException.Check(Native.mimo_batch_observe(Handle, chosen, Given.LengthOrNone(chosen), Blocks, (UIntPtr)Blocks.Length));
        }

        /// <summary>Reads a quantity of several ids in all worlds: worlds x Env.Width values.</summary>
        public void Get(Quantity quantity, int[] ids, double[] values)
        {
            MimoException.Check(Native.mimo_batch_get(Handle, (int)quantity, ids, Given.LengthOrNone(ids), null, UIntPtr.Zero, values,
                Given.LengthOf(values, "values")));
        }

        /// <summary>The same in single precision, for engines.</summary>
        public void Get(Quantity quantity, int[] ids, float[] values)
        {
            MimoException.Check(Native.mimo_batch_get_float(Handle, (int)quantity, ids, Given.LengthOrNone(ids), null, UIntPtr.Zero, values,
                Given.LengthOf(values, "values")));
        }

        /// <summary>Writes a quantity of several ids in all worlds: worlds x Env.Width values.</summary>
        public void Set(Quantity quantity, int[] ids, double[] values, bool[] mask = null)
        {
            var chosen = BytesOf(mask);
            MimoException.Check(Native.mimo_batch_set(Handle, (int)quantity, ids, Given.LengthOrNone(ids), chosen, Given.LengthOrNone(chosen), values,
                Given.LengthOf(values, "values")));
        }

        /// <summary>Sets the face of an infant.</summary>
        public void SetFace(string name, int agent = 0, bool[] mask = null)
        {
            var faces = new double[Worlds];
            for (var i = 0; i < faces.Length; ++i) faces[i] = first.Find(Kind.Face, name);
            Set(Quantity.AgentFace, new[] { agent }, faces, mask);
        }

        /// <summary>The states of all worlds, one after the other. Each has the size of the longest state.</summary>
        public byte[] Save()
        {
            UIntPtr bytes;
            MimoException.Check(Native.mimo_batch_state_size(Handle, out bytes));
            var states = new byte[Worlds * (int)bytes];
            MimoException.Check(Native.mimo_batch_state_save(Handle, null, UIntPtr.Zero, states, Given.LengthOf(states, "states")));
            return states;
        }

        /// <summary>Loads one state per world, or a single state into all worlds; if one is refused, no world
        /// changes. Returns the report of the world in which most sections started fresh.</summary>
        public LoadReport Load(byte[] states, bool[] mask = null)
        {
            var chosen = BytesOf(mask);
            return LoadReport.Of((ref LoadReportStruct report) =>
                Native.mimo_batch_state_load(Handle, chosen, Given.LengthOrNone(chosen), states, Given.LengthOf(states, "states"), ref report));
        }

        private static byte[] BytesOf(bool[] mask) { return mask?.Select(chosen => (byte)(chosen ? 1 : 0)).ToArray(); }

        /// <summary>Destroys the batch and its worlds.</summary>
        public void Dispose() { owned.Dispose(); }
    }
}
