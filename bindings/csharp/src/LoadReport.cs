using System;
using System.Collections.Generic;

namespace Mimo
{
    /// <summary>What a state did not hold of the world that loaded it, and the other way round: names of its sections.</summary>
    public sealed class LoadReport
    {
        /// <summary>Senses and motors with a delay that start fresh.</summary>
        public IReadOnlyList<string> Fresh { get; private set; }

        /// <summary>What the state holds, and nobody here has.</summary>
        public IReadOnlyList<string> Ignored { get; private set; }

        internal delegate int LoadCall(ref LoadReportStruct report);

        internal static LoadReport Of(LoadCall load)
        {
            var raw = LoadReportStruct.New();
            MimoException.Check(load(ref raw));
            return new LoadReport { Fresh = Names(raw.fresh_names), Ignored = Names(raw.ignored_names) };
        }

        private static string[] Names(IntPtr joined)
        {
            return Utf8.Of(joined).Split(new[] { ", " }, StringSplitOptions.RemoveEmptyEntries);
        }
    }
}
