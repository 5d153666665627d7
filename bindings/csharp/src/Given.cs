using System;

namespace Mimo
{
    /// <summary>Arguments that C could not be given, or that would say nothing there: refused in the library's words.</summary>
    internal static class Given
    {
        internal static MimoException Refusal(string message)
        {
            return new MimoException(Status.InvalidArgument, "MIMO_E_INVALID_ARGUMENT", message);
        }

        /// <summary>An array that this side of the border checks.</summary>
        internal static ArgumentException Misfit(Array array, string name, string but)
        {
            return new ArgumentException(name + " is " + Named(array) + ", " + but, name);
        }

        /// <summary>What is not null.</summary>
        internal static T Some<T>(T one, string name, string expected) where T : class
        {
            if (one == null) throw Refusal(name + " is null, expected " + expected);
            return one;
        }

        /// <summary>A text that says something: C takes "" as nothing given.</summary>
        internal static string Text(string text, string name, string expected)
        {
            if (Some(text, name, expected) == "") throw Refusal(name + " is \"\", expected " + expected);
            return text;
        }

        /// <summary>A number of something, or an index: no unsigned number is below 0.</summary>
        internal static uint Count(int number, string name)
        {
            if (number < 0) throw Refusal(name + " is " + number + ", expected a number from 0");
            return (uint)number;
        }

        /// <summary>An index of so many.</summary>
        internal static int Below(int index, int count, string name)
        {
            if (index < 0 || index >= count) throw Refusal(name + " is " + index + ", and there are " + count + ", counted from 0");
            return index;
        }

        internal static UIntPtr Index(int number, string name) { return (UIntPtr)Count(number, name); }

        /// <summary>Of an array that is there.</summary>
        internal static UIntPtr LengthOf(Array array, string name)
        {
            return (UIntPtr)Some(array, name, "an array").Length;
        }

        /// <summary>Of an array that may be left out.</summary>
        internal static UIntPtr LengthOrNone(Array array) { return (UIntPtr)(array == null ? 0 : array.Length); }

        // "Single[5]"
        private static string Named(Array array)
        {
            return array == null ? "null" : array.GetType().GetElementType().Name + "[" + array.Length + "]";
        }
    }
}
