using System;

namespace Mimo
{
    /// <summary>What is recorded, and how; what is not set is the library's default.</summary>
    public sealed class RecorderOptions
    {
        /// <summary>Fields to keep: "all", "none", or senses and fields with commas between them; null: proprioception and
        /// vestibular sense.</summary>
        public string Keep;
        /// <summary>Simulated seconds between states that are kept.</summary>
        public double StateSeconds = 1;
        /// <summary>Real seconds after which all is on its way to the disk.</summary>
        public double FlushSeconds = 1;
        /// <summary>0 for none to 9 for the smallest file.</summary>
        public uint Compression = 4;
        /// <summary>What the program wants to find again: a text, best JSON.</summary>
        public string Configuration;
        /// <summary>For people; replays do not need it.</summary>
        public ulong Seed;
        /// <summary>Path of the HDF5 library; null: the system's.</summary>
        public string Hdf5;
        /// <summary>A whole recording that is there, and that no program is using, is replaced; else it stays, and the
        /// recorder is refused.</summary>
        public bool Replace;
    }

    /// <summary>Records all steps of a world into an HDF5 file until it is closed, or the world is.</summary>
    public sealed class Recorder : IDisposable
    {
        private readonly RecorderHandle owned;
        private RecorderHandle Handle => Ending.Pass(owned);

        /// <summary>Records a world from now on. A recording that is there stays, and is an error, unless
        /// options.Replace is set.</summary>
        public Recorder(Env env, string path, RecorderOptions options = null)
        {
            options = options ?? new RecorderOptions();
            using (var keep = new PinnedText(options.Keep))
            using (var configuration = new PinnedText(options.Configuration))
            using (var hdf5 = new PinnedText(options.Hdf5))
            {
                RecorderConfigStruct config;
                MimoException.Check(Native.mimo_recorder_config_init(out config, Structs.Size<RecorderConfigStruct>()));
                config.compression = options.Compression;
                config.keep = keep.Pointer;
                config.state_seconds = options.StateSeconds;
                config.flush_seconds = options.FlushSeconds;
                config.configuration = configuration.Pointer;
                config.seed = options.Seed;
                config.hdf5 = hdf5.Pointer;
                config.replace = options.Replace ? 1u : 0u;
                MimoException.Check(Native.mimo_recorder_open(Given.Some(env, "env", "an Env").Handle, Utf8.Bytes(path), ref config, out owned));
                owned.World = env.Handle;
                Ending.Watch(owned);
            }
        }

        /// <summary>Puts everything on its way to the disk now.</summary>
        public void Flush() { MimoException.Check(Native.mimo_recorder_flush(Handle)); }

        /// <summary>Keeps the last state and closes the file; throws what could not be written.</summary>
        public void Close() { MimoException.Check(Native.mimo_recorder_close(Handle)); }

        /// <summary>Closes without a word of what could not be written.</summary>
        public void Dispose() { owned.Dispose(); }
    }
}
