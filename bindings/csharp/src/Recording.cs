using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Mimo
{
    /// <summary>Records all steps of a world into an HDF5 file until the recorder or the world is closed.</summary>
    public sealed class Recorder : IDisposable
    {
        private readonly RecorderHandle owned;
        private RecorderHandle Handle => Ending.Pass(owned);

        /// <summary>Records a world from now on. An existing recording is an error unless config.Replace is
        /// set.</summary>
        public Recorder(Env env, string path, RecorderConfig config = null)
        {
            using (var parts = new PinnedParts())
            {
                var raw = (config ?? new RecorderConfig()).Raw(parts);
                MimoException.Check(Native.mimo_recorder_open(Given.Some(env, "env", "an Env").Handle, Utf8.Bytes(path), ref raw, out owned));
                owned.World = env.Handle;
                Ending.Watch(owned);
            }
        }

        /// <summary>Writes everything recorded so far to the disk.</summary>
        public void Flush() { MimoException.Check(Native.mimo_recorder_flush(Handle)); }

        /// <summary>Saves the last state and closes the file. Throws if something could not be written.</summary>
        public void Close() { MimoException.Check(Native.mimo_recorder_close(Handle)); }

        /// <summary>Closes the file. Does not throw if something could not be written.</summary>
        public void Dispose() { owned.Dispose(); }
    }

    /// <summary>A recording, for reading and for replay in a world like the recorded one.</summary>
    public sealed class Recording : IDisposable
    {
        private readonly RecordingHandle owned;
        private RecordingHandle Handle => Ending.Pass(owned);
        private readonly bool hasAges; // infants of several ages

        /// <summary>Opens a recording. hdf5 is the path of the HDF5 library; null: the system's.</summary>
        public Recording(string path, string hdf5 = null)
        {
            Library.Require();
            MimoException.Check(Native.mimo_recording_open(Utf8.Bytes(path), Utf8.Bytes(hdf5), out owned));
            hasAges = Info.Bodies > 1;
        }

        /// <summary>Description of the recording.</summary>
        public RecordingInfo Info
        {
            get
            {
                var raw = RecordingInfoStruct.New();
                MimoException.Check(Native.mimo_recording_describe(Handle, ref raw));
                return new RecordingInfo(raw);
            }
        }

        /// <summary>Brings along a sense of your own that the recorded world had, by its name: see
        /// MimoScene.AddSense.</summary>
        public void AddSense(string name, Func<SenseOpening, MimoSense> make, IEnumerable<SenseParameter> parameters = null, int version = 0)
        {
            Sensing.Tell(name, make, parameters, version,
                (ref SenseStruct raw) => Native.mimo_recording_add_sense(Handle, ref raw));
        }

        /// <summary>The same for a sense in a shared library.</summary>
        public void LoadSense(string path)
        {
            MimoException.Check(Native.mimo_recording_load_sense(Handle, Utf8.Bytes(path)));
        }

        /// <summary>Number of rows of a dataset.</summary>
        public int Rows(string dataset)
        {
            UIntPtr rows, bytes;
            MimoException.Check(Native.mimo_recording_size(Handle, Utf8.Bytes(dataset), out rows, out bytes));
            return (int)rows;
        }

        /// <summary>Reads rows of a dataset, one after the other, in the file's type: float for actions and most
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

        /// <summary>A config that keeps all senses of the recording; change some of them for
        /// CreateEnv.</summary>
        public static AgentConfig SensesAsRecorded()
        {
            return new AgentConfig
            {
                Proprioception = (Proprioception)Constants.AsRecorded,
                Vestibular = (Vestibular)Constants.AsRecorded,
                Vision = (Vision)Constants.AsRecorded,
                Touch = (MimoTouch)Constants.AsRecorded,
                Hearing = (Hearing)Constants.AsRecorded,
            };
        }

        /// <summary>Creates the recorded world from the file alone. A custom task is not in the file: the world has
        /// one that does nothing, and a replay gives the recorded results. senses: what each infant senses; null: as
        /// recorded.</summary>
        public Env CreateEnv(EnvConfig config = null, AgentConfig senses = null)
        {
            return new Env((config ?? new EnvConfig()).Use((raw, log) =>
            {
                using (var parts = new PinnedParts())
                {
                    var wanted = (senses ?? SensesAsRecorded()).Raw(parts);
                    EnvHandle made;
                    var status = Native.mimo_recording_env(Handle, ref raw, ref wanted, out made);
                    made.Log = log;
                    Logging.CheckTold(status, log);
                    return made;
                }
            }));
        }

        /// <summary>Loads the last saved state that is not later than a step, and returns that state's step. Infants
        /// get the age that they had. Without Replay.Fields the world may have other senses. With Replay.Joints steps
        /// set the recorded joints, which works with any version.</summary>
        public int Seek(Env env, int step = 0, Replay how = Replay.Fields)
        {
            UIntPtr at;
            MimoException.Check(Native.mimo_recording_seek(Handle, Given.Some(env, "env", "an Env").Handle, Given.Index(step, "step"),
                (uint)how, out at));
            if (hasAges) env.Layout.Renew();
            return (int)at;
        }

        /// <summary>Replays the next step. The world holds its results and observation.</summary>
        public Step Step(Env env)
        {
            var step = Given.Some(env, "env", "an Env").Take((EnvHandle world, byte[] block, ref EnvResultsStruct results) =>
                Native.mimo_recording_step(Handle, world, block, (UIntPtr)block.Length, ref results));
            if (hasAges) env.Layout.Renew();
            return step;
        }

        /// <summary>Replays all remaining steps.</summary>
        public ReplayReport Play(Env env)
        {
            for (var left = Info.Steps - Report.Next; left > 0; --left) Step(env);
            return Report;
        }

        /// <summary>The result of all comparisons since the last Seek.</summary>
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
