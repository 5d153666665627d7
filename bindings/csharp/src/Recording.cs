using System;
using System.Runtime.InteropServices;

namespace Mimo
{
    /// <summary>A recording that is read, and played again in a world like the one that was recorded.</summary>
    public sealed class Recording : IDisposable
    {
        private readonly RecordingHandle owned;
        private RecordingHandle Handle => Ending.Pass(owned);
        private readonly bool grows; // infants do

        /// <summary>Opens a recording; hdf5 is the path of the HDF5 library, null: the system's.</summary>
        public Recording(string path, string hdf5 = null)
        {
            Library.Require();
            MimoException.Check(Native.mimo_recording_open(Utf8.Bytes(path), Utf8.Bytes(hdf5), out owned));
            grows = Info.Bodies > 1;
        }

        /// <summary>What it holds.</summary>
        public RecordingInfo Info
        {
            get
            {
                var raw = RecordingInfoStruct.New();
                MimoException.Check(Native.mimo_recording_describe(Handle, ref raw));
                return new RecordingInfo(raw);
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
                var raw = ReplayReportStruct.New();
                MimoException.Check(Native.mimo_recording_report(Handle, ref raw));
                return new ReplayReport(raw);
            }
        }

        /// <summary>Closes the file.</summary>
        public void Dispose() { owned.Dispose(); }
    }
}
