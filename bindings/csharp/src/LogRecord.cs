namespace Mimo
{
    /// <summary>How much a message matters; values are those of mimo.h.</summary>
    public enum MessageLevel
    {
        /// <summary>Something is not as the user probably meant it.</summary>
        Warning = 1,
        /// <summary>Worth knowing, once.</summary>
        Info = 2
    }

    /// <summary>What physics warns of; also the ids of Kind.Warning. Values are those of mimo.h.</summary>
    public enum Warning
    {
        /// <summary>Something else, or it is not physics that has something to say.</summary>
        Other = 0,
        /// <summary>More contacts than the model's nconmax: some are missing.</summary>
        ContactsDropped = 1,
        /// <summary>More constraints than the model's njmax: some are missing.</summary>
        ConstraintsDropped = 2,
        /// <summary>A position that is no number, or huge: the world has failed.</summary>
        BadPosition = 3,
        /// <summary>The same of a velocity.</summary>
        BadVelocity = 4,
        /// <summary>The same of an acceleration.</summary>
        BadAcceleration = 5,
        /// <summary>A control that is no number, or huge: the step took all as 0.</summary>
        BadControl = 6,
        /// <summary>The inertia matrix is nearly singular.</summary>
        Inertia = 7,
        /// <summary>The solver stopped at its last iteration; counted, not told.</summary>
        NotConverged = 8
    }

    /// <summary>A message of the library.</summary>
    public struct LogRecord
    {
        /// <summary>How much it matters.</summary>
        public MessageLevel Level;
        /// <summary>What it is about, where physics warns.</summary>
        public Warning Code;
        /// <summary>One line.</summary>
        public string Text;
        /// <summary>Number of the world in its batch whose physics warns, 0 for a single one; null where a scene, a model or
        /// a renderer has something to say.</summary>
        public int? World;
        /// <summary>Simulated seconds since the world's reset.</summary>
        public double Time;

        internal static LogRecord Of(ref LogRecordStruct raw)
        {
            return new LogRecord
            {
                Level = (MessageLevel)raw.level, Code = (Warning)raw.code, Text = MimoException.Named(Utf8.Of(raw.text)),
                World = raw.in_world != 0 ? (int)raw.world : (int?)null, Time = raw.time
            };
        }
    }
}
