namespace Mimo
{
    /// <summary>A message of the library.</summary>
    public struct LogRecord
    {
        /// <summary>How much it matters.</summary>
        public LogLevel Level;
        /// <summary>The warning; null where it is not one of physics.</summary>
        public WarningCode? Code;
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
                Level = (LogLevel)raw.level, Code = raw.code != 0 ? (WarningCode)raw.code : (WarningCode?)null, Text = MimoException.Named(Utf8.Of(raw.text)),
                World = raw.in_world != 0 ? (int)raw.world : (int?)null, Time = raw.time
            };
        }
    }
}
