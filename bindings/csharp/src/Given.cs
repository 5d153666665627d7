using System;

namespace Mimo
{
    /// <summary>Checks of arguments that C cannot receive or would take as missing. Their messages read like the
    /// library's.</summary>
    internal static class Given
    {
        internal static MimoException Refusal(string message)
        {
            return new MimoException(Status.InvalidArgument, "MIMO_E_INVALID_ARGUMENT", message);
        }

        /// <summary>The exception for an array of the wrong type or length.</summary>
        internal static ArgumentException Misfit(Array array, string name, string but)
        {
            return new ArgumentException(name + " is " + Named(array) + ", " + but, name);
        }

        /// <summary>Refuses null.</summary>
        internal static T Some<T>(T one, string name, string expected) where T : class
        {
            if (one == null) throw Refusal(name + " is null, expected " + expected);
            return one;
        }

        /// <summary>Refuses null and "", which C takes as missing.</summary>
        internal static string Text(string text, string name, string expected)
        {
            if (Some(text, name, expected) == "") throw Refusal(name + " is \"\", expected " + expected);
            return text;
        }

        /// <summary>Refuses negative numbers, which the library's unsigned numbers cannot hold.</summary>
        internal static uint Count(int number, string name)
        {
            if (number < 0) throw Refusal(name + " is " + number + ", expected 0 or more");
            return (uint)number;
        }

        /// <summary>Refuses an index outside 0 to count - 1.</summary>
        internal static int Below(int index, int count, string name)
        {
            if (index < 0 || index >= count) throw Refusal(name + " is " + index + ", but there are " + count + ", counted from 0");
            return index;
        }

        internal static UIntPtr Index(int number, string name) { return (UIntPtr)Count(number, name); }

        /// <summary>The length of an array; refuses null.</summary>
        internal static UIntPtr LengthOf(Array array, string name)
        {
            return (UIntPtr)Some(array, name, "an array").Length;
        }

        /// <summary>The length of an array, 0 for null.</summary>
        internal static UIntPtr LengthOrNone(Array array) { return (UIntPtr)(array == null ? 0 : array.Length); }

        /// <summary>How many rows of so many numbers an array has; refuses null, and numbers left over.</summary>
        internal static UIntPtr Rows(float[] numbers, int width, string name)
        {
            if (Some(numbers, name, "an array").Length % width != 0)
                throw Misfit(numbers, name, "expected " + width + " numbers for each");
            return (UIntPtr)(numbers.Length / width);
        }

        // "Single[5]"
        private static string Named(Array array)
        {
            return array == null ? "null" : array.GetType().GetElementType().Name + "[" + array.Length + "]";
        }
    }
}
