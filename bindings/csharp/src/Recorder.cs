using System;

namespace Mimo
{
    /// <summary>Records all steps of a world into an HDF5 file until it is closed, or the world is.</summary>
    public sealed class Recorder : IDisposable
    {
        private readonly RecorderHandle owned;
        private RecorderHandle Handle => Ending.Pass(owned);

        /// <summary>Records a world from now on. A recording that is there stays, and is an error, unless
        /// config.Replace is set.</summary>
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

        /// <summary>Puts everything on its way to the disk now.</summary>
        public void Flush() { MimoException.Check(Native.mimo_recorder_flush(Handle)); }

        /// <summary>Keeps the last state and closes the file; throws what could not be written.</summary>
        public void Close() { MimoException.Check(Native.mimo_recorder_close(Handle)); }

        /// <summary>Closes without a word of what could not be written.</summary>
        public void Dispose() { owned.Dispose(); }
    }
}
