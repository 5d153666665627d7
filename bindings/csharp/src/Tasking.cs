using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.InteropServices;
using System.Threading;
using Mimo.Callbacks;

namespace Mimo
{
    /// <summary>Passes the library's calls to a user's task, which it keeps alive. The scene, worlds and their clones
    /// share it; the last one that is destroyed releases it.</summary>
    internal sealed class Tasking
    {
        /// <summary>The objects of one world, made once and used again in each call.</summary>
        private sealed class Seat
        {
            internal Env World;
            internal TaskMoment[] Moments;
            internal TaskVerdict[] Verdicts;
        }

        // Static fields keep the delegates alive as long as the library may call them.
        private static readonly Native.TaskResetFunction reset = Reset;
        private static readonly Native.TaskEvaluateFunction evaluate = Evaluate;

        private readonly MimoTask task;
        private readonly int memory, terms, fields;
        private readonly ConcurrentDictionary<IntPtr, Seat> seats = new ConcurrentDictionary<IntPtr, Seat>();
        private readonly GCHandle kept;
        private int shares = 1;

        private Tasking(MimoTask task, int terms, IEnumerable<TaskField> fields)
        {
            this.task = task;
            this.terms = terms;
            memory = task.Memory;
            this.fields = fields.Sum(field => field.Shape.Aggregate(1, (count, size) => count * size));
            kept = GCHandle.Alloc(this);
        }

        /// <summary>Sets a scene's task; null removes it.</summary>
        internal static Tasking Tell(SceneHandle scene, MimoTask task)
        {
            if (task == null)
            {
                MimoException.Check(Native.mimo_scene_set_task(scene, IntPtr.Zero));
                return null;
            }
            var terms = Given.Some(task.Terms, "Terms", "a list of names");
            var fields = Given.Some(task.Fields, "Fields", "a list of fields");
            foreach (var field in fields) Given.Some(Given.Some(field, "an element of Fields", "a TaskField").Shape, "Shape", "an array");
            Given.Count(task.Memory, "Memory");
            var tasking = new Tasking(task, terms.Count, fields);
            using (var words = new PinnedParts())
            {
                var raw = TaskStruct.New();
                raw.user = GCHandle.ToIntPtr(tasking.kept);
                raw.memory_bytes = (UIntPtr)((ulong)tasking.memory * sizeof(double));
                raw.reset = Marshal.GetFunctionPointerForDelegate(reset);
                raw.evaluate = Marshal.GetFunctionPointerForDelegate(evaluate);
                raw.terms = words.Keep(terms.Select(words.Text).ToArray());
                raw.term_count = (UIntPtr)terms.Count;
                raw.fields = words.Keep(fields.Select(field => Described(field, words)).ToArray());
                raw.field_count = (UIntPtr)fields.Count;
                var status = Native.mimo_scene_set_task(scene, words.Keep(new[] { raw }));
                if (status != 0) tasking.kept.Free();
                MimoException.Check(status);
            }
            return tasking;
        }

        private static TaskFieldStruct Described(TaskField field, PinnedParts words)
        {
            var raw = TaskFieldStruct.New();
            raw.name = words.Text(field.Name);
            raw.unit = words.Text(field.Unit);
            raw.frame = words.Text(field.Frame);
            raw.shape = words.Keep(field.Shape.Select(size => Given.Index(size, "size")).ToArray());
            raw.ndim = (uint)field.Shape.Length;
            raw.low = field.Low;
            raw.high = field.High;
            return raw;
        }

        internal Tasking Share()
        {
            Interlocked.Increment(ref shares);
            return this;
        }

        /// <summary>Releases the share of a destroyed world.</summary>
        internal void Release(IntPtr world)
        {
            Seat gone;
            seats.TryRemove(world, out gone);
            Release();
        }

        internal void Release()
        {
            if (Interlocked.Decrement(ref shares) == 0) kept.Free();
        }

        private Seat SeatOf(IntPtr world)
        {
            Seat seat;
            if (seats.TryGetValue(world, out seat)) return seat;
            var env = new Env(new EnvHandle(world));
            seat = new Seat
            {
                World = env,
                Moments = Enumerable.Range(0, env.Layout.Agents).Select(_ => new TaskMoment(memory, fields)).ToArray(),
                Verdicts = Enumerable.Range(0, env.Layout.Agents).Select(_ => new TaskVerdict(terms)).ToArray()
            };
            seats[world] = seat;
            return seat;
        }

        [MonoPInvokeCallback(typeof(Native.TaskResetFunction))]
        private static int Reset(IntPtr user, IntPtr world, ref TaskMomentStruct told)
        {
            try
            {
                if (!Ending.Enter()) return Fail(new InvalidOperationException("the program is ending"));
                var tasking = (Tasking)GCHandle.FromIntPtr(user).Target;
                var seat = tasking.SeatOf(world);
                var moment = seat.Moments[(int)told.agent];
                moment.Begin(ref told);
                tasking.task.Reset(seat.World, moment);
                moment.End(ref told);
                return 0;
            }
            catch (Exception error)
            {
                return Fail(error);
            }
            finally
            {
                Ending.Leave();
            }
        }

        [MonoPInvokeCallback(typeof(Native.TaskEvaluateFunction))]
        private static int Evaluate(IntPtr user, IntPtr world, ref TaskMomentStruct told, ref TaskVerdictStruct said)
        {
            try
            {
                if (!Ending.Enter()) return Fail(new InvalidOperationException("the program is ending"));
                var tasking = (Tasking)GCHandle.FromIntPtr(user).Target;
                var seat = tasking.SeatOf(world);
                TaskMoment moment = seat.Moments[(int)told.agent];
                TaskVerdict verdict = seat.Verdicts[(int)told.agent];
                moment.Begin(ref told);
                verdict.Begin();
                tasking.task.Evaluate(seat.World, moment, verdict);
                moment.End(ref told);
                verdict.End(ref said);
                return 0;
            }
            catch (Exception error)
            {
                return Fail(error);
            }
            finally
            {
                Ending.Leave();
            }
        }

        /// <summary>An exception must not unwind through the library's frames.</summary>
        internal static int Fail(Exception error)
        {
            var known = error as MimoException;
            return Native.mimo_fail((int)(known == null ? Status.Task : known.Status),
                Utf8.Bytes(known == null ? error.GetType().Name + ": " + error.Message : error.Message));
        }
    }
}
