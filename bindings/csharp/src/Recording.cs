using System;
using System.Runtime.InteropServices;

namespace Mimo
{
    /// <summary>What a recording holds.</summary>
    public sealed class RecordingInfo
    {
        /// <summary>Of the file.</summary>
        public int FormatVersion { get; internal set; }
        /// <summary>The loaded library is the one that recorded.</summary>
        public bool SameBuild { get; internal set; }
        /// <summary>That can be played.</summary>
        public int Steps { get; internal set; }
        /// <summary>That were kept.</summary>
        public int States { get; internal set; }
        /// <summary>Ages that infants had.</summary>
        public int Bodies { get; internal set; }
        /// <summary>Of one step.</summary>
        public double StepSeconds { get; internal set; }
        /// <summary>Versions and build that recorded.</summary>
        public string Build { get; internal set; }
        /// <summary>Of the loaded library.</summary>
        public string ThisBuild { get; internal set; }
        /// <summary>What the recording program left.</summary>
        public string Configuration { get; internal set; }
        /// <summary>As a decimal number.</summary>
        public string Seed { get; internal set; }
    }

    /// <summary>What a replay has shown so far.</summary>
    public sealed class ReplayReport
    {
        /// <summary>All that was compared was the same to the last bit.</summary>
        public bool Identical { get; internal set; }
        /// <summary>The step that comes next.</summary>
        public int Next { get; internal set; }
        /// <summary>How many were played.</summary>
        public int Steps { get; internal set; }
        /// <summary>The first step that differed.</summary>
        public int FirstDifference { get; internal set; }
        /// <summary>Of any number.</summary>
        public double LargestDifference { get; internal set; }
        /// <summary>The dataset in which that was, "" where all was identical.</summary>
        public string DiffersMostIn { get; internal set; }
    }

    /// <summary>A recording that is read, and played again in a world like the one that was recorded.</summary>
    public sealed class Recording : IDisposable
    {
        private readonly RecordingHandle owned;
        private RecordingHandle Handle => Ending.Pass(owned);
        private readonly bool grows; // infants do

        /// <summary>Opens a recording; hdf5 is the path of the HDF5 library, null: the system's.</summary>
        public Recording(string path, string hdf5 = null)
        {
            MimoException.Check(Native.mimo_recording_open(Utf8.Bytes(path), Utf8.Bytes(hdf5), out owned));
            grows = Info.Bodies > 1;
        }

        /// <summary>What it holds.</summary>
        public RecordingInfo Info
        {
            get
            {
                var raw = new RecordingInfoStruct { struct_size = (uint)Structs.Size<RecordingInfoStruct>() };
                MimoException.Check(Native.mimo_recording_describe(Handle, ref raw));
                return new RecordingInfo
                {
                    FormatVersion = (int)raw.format_version, SameBuild = raw.same_build != 0, Steps = (int)raw.steps,
                    States = (int)raw.states, Bodies = (int)raw.bodies, StepSeconds = raw.step_seconds,
                    Build = Utf8.Of(raw.build), ThisBuild = Utf8.Of(raw.this_build),
                    Configuration = Utf8.Of(raw.configuration), Seed = Utf8.Of(raw.seed)
                };
            }
        }

        /// <summary>How many rows a dataset has.</summary>
        public int Rows(string dataset)
        {
            UIntPtr rows, bytes;
            MimoException.Check(Native.mimo_recording_size(Handle, Utf8.Bytes(dataset), out rows, out bytes));
            return (int)rows;
        }

        /// <summary>Rows of a dataset, one behind the other, of the type that it has in the file: float for actions and most
        /// fields, double for joints and rewards.</summary>
        public T[] Read<T>(string dataset, int first, int rows) where T : struct
        {
            UIntPtr there, bytes;
            var name = Utf8.Bytes(dataset);
            MimoException.Check(Native.mimo_recording_size(Handle, name, out there, out bytes));
            var values = new T[(int)((long)bytes * Math.Max(0, Math.Min(rows, (int)there)) / Marshal.SizeOf<T>())];
            using (var place = new Pinned(values))
            {
                var room = (UIntPtr)((long)values.Length * Marshal.SizeOf<T>());
                MimoException.Check(Native.mimo_recording_read(Handle, name, Given.Index(first, "first"),
                    Given.Index(rows, "rows"), place.Pointer, room));
            }
            return values;
        }

        /// <summary>Loads the last kept state that is not later than a step; gives that state's step. Without compareFields
        /// the world may sense otherwise. Infants become as old as they were.</summary>
        public int Seek(Env env, int step = 0, bool compareFields = true)
        {
            UIntPtr at;
            MimoException.Check(Native.mimo_recording_seek(Handle, Given.Some(env, "env", "an Env").Handle, Given.Index(step, "step"),
                compareFields ? 1u : 0u, out at));
            if (grows) env.Layout.Renew();
            return (int)at;
        }

        /// <summary>Plays the next step; its results and observation are the world's.</summary>
        public Step Step(Env env)
        {
            var step = Given.Some(env, "env", "an Env").Take((EnvHandle world, byte[] block, ref EnvResultsStruct results) =>
                Native.mimo_recording_step(Handle, world, block, (UIntPtr)block.Length, ref results));
            if (grows) env.Layout.Renew();
            return step;
        }

        /// <summary>Plays all that is left.</summary>
        public ReplayReport Play(Env env)
        {
            for (var left = Info.Steps - Report.Next; left > 0; --left) Step(env);
            return Report;
        }

        /// <summary>What was compared since the last Seek.</summary>
        public ReplayReport Report
        {
            get
            {
                var raw = new ReplayReportStruct { struct_size = (uint)Structs.Size<ReplayReportStruct>() };
                MimoException.Check(Native.mimo_recording_report(Handle, ref raw));
                return new ReplayReport
                {
                    Identical = raw.identical != 0, Next = (int)raw.next, Steps = (int)raw.steps,
                    FirstDifference = (int)raw.first_difference, LargestDifference = raw.largest_difference,
                    DiffersMostIn = Utf8.Of(raw.differs_most_in)
                };
            }
        }

        /// <summary>Closes the file.</summary>
        public void Dispose() { owned.Dispose(); }
    }
}
