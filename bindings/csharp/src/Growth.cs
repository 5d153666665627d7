using System.Runtime.InteropServices;

namespace Mimo
{
    /// <summary>Whose growth an infant follows.</summary>
    public enum Sex
    {
        /// <summary>The mean of the medians of girls and boys.</summary>
        Mean = 0,
        /// <summary>A girl.</summary>
        Female = 1,
        /// <summary>A boy.</summary>
        Male = 2
    }

    /// <summary>Where the sizes of an infant's body come from.</summary>
    public enum GrowthModel
    {
        /// <summary>The WHO's child growth standards and measured infants.</summary>
        Who = 0,
        /// <summary>The rules of MIMo's second version.</summary>
        Original = 1
    }

    /// <summary>How old, large and strong an infant is. mimo_growth of mimo.h, whose comments hold.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Growth
    {
        /// <summary>The body of 18 months.</summary>
        public static Growth Default
        {
            get
            {
                Library.Require();
                Growth growth;
                MimoException.Check(Native.mimo_growth_init(out growth, Structs.Size<Growth>()));
                return growth;
            }
        }

        /// <summary>The median infant of an age, months from 0 to 24.</summary>
        public static Growth OfAge(double months)
        {
            Growth growth = Default;
            growth.age = months;
            return growth;
        }

        internal uint struct_size;
        /// <summary>Whose growth it follows.</summary>
        public Sex sex;
        /// <summary>Months, 0 to 24: of size and mass.</summary>
        public double age;
        /// <summary>Months, 0 to 24, where matures_apart is 1: of strength, range of motion and tone.</summary>
        public double physiological_age;
        /// <summary>1: physiological_age counts; 0: it is the age.</summary>
        public uint matures_apart;
        /// <summary>Where the sizes come from.</summary>
        public GrowthModel model;
        /// <summary>Of its length: standard deviations from the median of age and sex, -3 to 3.</summary>
        public double z_length;
        /// <summary>Of its weight, the same.</summary>
        public double z_weight;
        /// <summary>Of its head's circumference, the same.</summary>
        public double z_head;
        /// <summary>Percent, 1 to 99.865: all three of these at once, which are 0 then; 0: they count.</summary>
        public double percentile;
        /// <summary>Strength of a muscle's cross-section goes with this power of the median length at that age.</summary>
        public double strength_exponent;
        /// <summary>Factor of the neck's strength.</summary>
        public double neck_strength;
        /// <summary>Factor of the stiffness of a newborn's joints.</summary>
        public double birth_tone;
        /// <summary>Share of a young infant's lack of extension, 0 to 1.</summary>
        public double contracture;
        /// <summary>1: length and weight are the WHO's; 0: in the WHO's proportion to the body of 18 months.</summary>
        public uint absolute;
        /// <summary>1: touch sensors are as far apart as at 18 months; 0: there are as many.</summary>
        public uint keep_spacing;
        /// <summary>What of it is as old; at first its body alone.</summary>
        public Mature maturity;
        internal uint reserved;
    }
}
