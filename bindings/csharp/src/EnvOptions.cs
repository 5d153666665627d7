using System;

namespace Mimo
{
    /// <summary>What pictures show; what is left out costs nothing. Values are those of mimo.h.</summary>
    [Flags]
    public enum Render
    {
        /// <summary>Nothing of it.</summary>
        Plain = 0,
        /// <summary>Lights cast shadows.</summary>
        Shadows = 0x01,
        /// <summary>Floors and boxes may mirror what is before them.</summary>
        Reflections = 0x02,
        /// <summary>The scene's sky.</summary>
        Sky = 0x04,
        /// <summary>Haze at the horizon of an endless floor.</summary>
        Haze = 0x08,
        /// <summary>Fog, as the scene's MJCF describes it.</summary>
        Fog = 0x10
    }

    /// <summary>How MuJoCo solves for forces: the same solution to rounding. Values are those of mimo.h.</summary>
    public enum Jacobian
    {
        /// <summary>As the model says; built-in scenes say sparse.</summary>
        Model = 0,
        /// <summary>As the original solves; for comparing trajectories to the last digit.</summary>
        Dense = 1,
        /// <summary>About twice as fast.</summary>
        Sparse = 2
    }

    /// <summary>Parts of physics to leave out. Values are those of mimo.h.</summary>
    [Flags]
    public enum Disable : uint
    {
        /// <summary>All is simulated.</summary>
        Nothing = 0,
        /// <summary>No contacts.</summary>
        Contact = 0x1,
        /// <summary>No gravity.</summary>
        Gravity = 0x2,
        /// <summary>mj_step as it is, instead of libmimo's solver: same to rounding, slower.</summary>
        OwnSolver = 0x4
    }

    /// <summary>How a world is simulated; what is not set is the library's default.</summary>
    public sealed class EnvOptions
    {
        /// <summary>One of Tasks.Names, "none", "reach", ...; null: the scene's own.</summary>
        public string Task;
        /// <summary>"ray", "osmesa", "gl" (a graphics card), "none"; null: what works.</summary>
        public string Renderer;
        /// <summary>Physics steps of 5 ms per step; 0: the scene's own.</summary>
        public uint FrameSkip;
        /// <summary>Steps after which an episode is truncated; 0: the task's own.</summary>
        public uint MaxSteps;
        /// <summary>How MuJoCo solves for forces.</summary>
        public Jacobian Jacobian;
        /// <summary>Parts of physics to leave out.</summary>
        public Disable Disable;
        /// <summary>Whether Env.Timing counts, which costs a few clock reads a step.</summary>
        public bool Timing;
        /// <summary>Whether what touched what during a step is recorded, for Env.StepContacts.</summary>
        public bool StepContacts;
        /// <summary>What pictures show; null: everything but fog.</summary>
        public Render? Render;
        /// <summary>Samples a pixel for smooth edges: 1, 4, 16 or 64; 0: one ray, or what the model tells OpenGL.</summary>
        public uint Samples;
        /// <summary>Threads that draw one picture, 1 to 64; 1 is best in batches.</summary>
        public uint RenderThreads = 1;
        /// <summary>Receives messages while the world is made, reset and stepped, on the calling thread. Exceptions in it are
        /// dropped.</summary>
        public Action<LogRecord> Log;

        /// <summary>Makes something of the C struct of these options; it takes over the log, also when it fails.</summary>
        internal T Use<T>(Func<EnvConfigStruct, Logging, T> make)
        {
            using (PinnedText task = new PinnedText(Task), renderer = new PinnedText(Renderer))
            {
                EnvConfigStruct config;
                MimoException.Check(Native.mimo_env_config_init(out config, Structs.Size<EnvConfigStruct>()));
                if (Task != null) config.task = task.Pointer;
                if (Renderer != null) config.renderer = renderer.Pointer;
                config.frame_skip = FrameSkip;
                config.max_steps = MaxSteps;
                config.jacobian = (int)Jacobian;
                config.disable = (uint)Disable;
                config.timing = Timing ? 1u : 0u;
                config.step_contacts = StepContacts ? 1u : 0u;
                if (Render.HasValue) config.render = (uint)Render.Value;
                config.samples = Samples;
                config.render_threads = RenderThreads;
                var log = Logging.Tell(Log, out config.log, out config.log_user);
                return make(config, log);
            }
        }
    }
}
