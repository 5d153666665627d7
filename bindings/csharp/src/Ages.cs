namespace Mimo
{
    public sealed partial class Growth
    {
        /// <summary>The median infant of an age, months from 0 to 24.</summary>
        public static Growth OfAge(double months) { return new Growth { Age = months }; }
    }

    public sealed partial class Maturity
    {
        /// <summary>Eyes and nerves of an age, months from 0 to 24. ContrastThreshold and Flicker, which are options, stay
        /// off.</summary>
        public static Maturity OfAge(double months)
        {
            Library.Require();
            MaturityStruct raw;
            MimoException.Check(Native.mimo_maturity_at(months, out raw, (System.UIntPtr)MaturityStruct.Bytes));
            return new Maturity(raw);
        }
    }
}
