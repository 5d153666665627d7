using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.InteropServices;
using Mimo.Callbacks;

namespace Mimo
{
    /// <summary>Passes the library's calls to senses of the user's own. The library keeps it until nobody has the sense
    /// any more.</summary>
    internal sealed class Sensing
    {
        /// <summary>A sense at work.</summary>
        private sealed class Seat
        {
            internal MimoSense Sense;
            internal SenseMoment Moment;
        }

        // Static fields keep the delegates alive as long as the library may call them.
        private static readonly Native.SenseOpenFunction open = Open;
        private static readonly Native.SenseCloseFunction close = Close;
        private static readonly Native.SenseFunction reset = Reset;
        private static readonly Native.SenseFunction advance = Advance;
        private static readonly Native.SenseFunction write = Write;
        private static readonly Native.SenseReleaseFunction release = Release;

        private readonly Func<SenseOpening, MimoSense> make;
        private readonly int parameters;

        private Sensing(Func<SenseOpening, MimoSense> make, int parameters)
        {
            this.make = make;
            this.parameters = parameters;
        }

        internal delegate int Take(ref SenseStruct sense);

        /// <summary>Gives the table of a sense to a function of the library.</summary>
        internal static void Tell(string name, Func<SenseOpening, MimoSense> make, IEnumerable<SenseParameter> parameters, int version, Take take)
        {
            Given.Some(make, "make", "a function");
            var all = (parameters ?? new SenseParameter[0]).ToArray();
            using (var words = new PinnedParts())
            {
                SenseStruct raw;
                MimoException.Check(Native.mimo_sense_init(out raw, (UIntPtr)SenseStruct.Bytes));
                raw.interface_version = Constants.SenseInterface;
                raw.name = words.Text(name);
                raw.version = Given.Count(version, "version");
                raw.parameters = words.Keep(all.Select(one => Described(one, words)).ToArray());
                raw.parameter_count = (UIntPtr)all.Length;
                raw.open = Marshal.GetFunctionPointerForDelegate(open);
                raw.close = Marshal.GetFunctionPointerForDelegate(close);
                raw.reset = Marshal.GetFunctionPointerForDelegate(reset);
                raw.advance = Marshal.GetFunctionPointerForDelegate(advance);
                raw.write = Marshal.GetFunctionPointerForDelegate(write);
                raw.release = Marshal.GetFunctionPointerForDelegate(release);
                var kept = GCHandle.Alloc(new Sensing(make, all.Length));
                raw.user = GCHandle.ToIntPtr(kept);
                var status = take(ref raw);
                if (status != 0) kept.Free();
                MimoException.Check(status);
            }
        }

        private static ParameterStruct Described(SenseParameter parameter, PinnedParts words)
        {
            Given.Some(parameter, "an element of parameters", "a SenseParameter");
            var raw = ParameterStruct.New();
            raw.name = words.Text(parameter.Name);
            raw.description = words.Text(parameter.Description);
            raw.standard = parameter.Standard;
            raw.low = parameter.Low;
            raw.high = parameter.High;
            return raw;
        }

        [MonoPInvokeCallback(typeof(Native.SenseOpenFunction))]
        private static int Open(IntPtr user, IntPtr world, ref SenseMomentStruct told, ref SenseNeedsStruct needs)
        {
            try
            {
                if (!Ending.Enter()) return Tasking.Fail(new InvalidOperationException("the program is ending"));
                var sensing = (Sensing)GCHandle.FromIntPtr(user).Target;
                var handle = new EnvHandle(world);
                var env = new Env(handle);
                var values = new double[sensing.parameters];
                if (values.Length > 0) Marshal.Copy(told.parameters, values, 0, values.Length);
                var opening = new SenseOpening(handle, env, values, ref told);
                var sense = Given.Some(sensing.make(opening), "the result of make", "a MimoSense");
                var memory = (int)Given.Count(opening.Memory, "Memory");
                var moment = new SenseMoment(handle, env, values, memory, opening.Counts, told);
                needs.memory_bytes = (UIntPtr)((ulong)memory * sizeof(double));
                needs.sensors = opening.Sensors ? 1u : 0u;
                needs.own = GCHandle.ToIntPtr(GCHandle.Alloc(new Seat { Sense = sense, Moment = moment }));
                return 0;
            }
            catch (Exception error)
            {
                return Tasking.Fail(error);
            }
            finally
            {
                Ending.Leave();
            }
        }

        [MonoPInvokeCallback(typeof(Native.SenseCloseFunction))]
        private static void Close(IntPtr user, IntPtr own) { GCHandle.FromIntPtr(own).Free(); }

        [MonoPInvokeCallback(typeof(Native.SenseReleaseFunction))]
        private static void Release(IntPtr user) { GCHandle.FromIntPtr(user).Free(); }

        private static int Run(ref SenseMomentStruct told, Action<Seat> work)
        {
            try
            {
                if (!Ending.Enter()) return Tasking.Fail(new InvalidOperationException("the program is ending"));
                var seat = (Seat)GCHandle.FromIntPtr(told.own).Target;
                seat.Moment.Begin(ref told);
                work(seat);
                return 0;
            }
            catch (Exception error)
            {
                return Tasking.Fail(error);
            }
            finally
            {
                Ending.Leave();
            }
        }

        private static readonly Action<Seat> resets = seat =>
        {
            seat.Sense.Reset(seat.Moment);
            seat.Moment.Keep();
        };

        private static readonly Action<Seat> advances = seat =>
        {
            seat.Sense.Advance(seat.Moment);
            seat.Moment.Keep();
        };

        private static readonly Action<Seat> writes = seat =>
        {
            seat.Moment.Clear();
            seat.Sense.Write(seat.Moment);
            seat.Moment.Hand();
        };

        [MonoPInvokeCallback(typeof(Native.SenseFunction))]
        private static int Reset(IntPtr user, IntPtr world, ref SenseMomentStruct told) { return Run(ref told, resets); }

        [MonoPInvokeCallback(typeof(Native.SenseFunction))]
        private static int Advance(IntPtr user, IntPtr world, ref SenseMomentStruct told) { return Run(ref told, advances); }

        [MonoPInvokeCallback(typeof(Native.SenseFunction))]
        private static int Write(IntPtr user, IntPtr world, ref SenseMomentStruct told) { return Run(ref told, writes); }
    }
}
