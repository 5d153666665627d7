using System;
using System.Runtime.InteropServices;

namespace Mimo
{
    /// <summary>What of an infant is as old as it; values are those of mimo.h.</summary>
    [Flags]
    public enum Mature : uint
    {
        /// <summary>Size, mass, strength and joints.</summary>
        Body = 0x1,
        /// <summary>What its eyes see.</summary>
        Eyes = 0x2,
        /// <summary>How long its nerves take, to and from the brain.</summary>
        Delays = 0x4,
        /// <summary>With its eyes: contrasts too faint for them are gone.</summary>
        Threshold = 0x8,
        /// <summary>With its eyes: changes too fast for them are blurred.</summary>
        Flicker = 0x10,
        /// <summary>All that the library has but Threshold and Flicker.</summary>
        All = 0x80000000
    }

    /// <summary>How mature an agent's eyes and nerves are, in numbers. mimo_maturity of mimo.h, whose comments hold.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Maturity
    {
        /// <summary>Perfect eyes, and nerves that take no time.</summary>
        public static Maturity Default
        {
            get
            {
                Library.Require();
                Maturity maturity;
                MimoException.Check(Native.mimo_maturity_init(out maturity, Structs.Size<Maturity>()));
                return maturity;
            }
        }

        /// <summary>Those of an age, months from 0 to 24; contrast_threshold and flicker, which are options, stay
        /// 0.</summary>
        public static Maturity OfAge(double months)
        {
            Library.Require();
            Maturity maturity;
            MimoException.Check(Native.mimo_maturity_at(months, out maturity, Structs.Size<Maturity>()));
            return maturity;
        }

        internal uint struct_size;
        /// <summary>1: contrasts too faint for such eyes are gone; 0: they stay.</summary>
        public uint contrast_threshold;
        /// <summary>The finest lines that are seen, cycles per degree; 0: pictures as drawn.</summary>
        public double acuity;
        /// <summary>The greatest contrast sensitivity.</summary>
        public double peak_contrast;
        /// <summary>Share of colour that is seen, 0 (grey) to 1.</summary>
        public double chroma;
        /// <summary>Faster changes are seen less and less, Hz; 0: all are seen.</summary>
        public double flicker;
        /// <summary>Of large nerve fibres, m/s; 0: they take no time.</summary>
        public double conduction_speed;
        /// <summary>From the brain stem to the cortex, s.</summary>
        public double sensory_delay;
        /// <summary>From the cortex to the brain stem, s.</summary>
        public double motor_delay;
        /// <summary>From the eye to the cortex, s.</summary>
        public double vision_delay;
        /// <summary>From the inner ear to the brain stem, s.</summary>
        public double vestibular_delay;
        /// <summary>From the ear to the cortex, s.</summary>
        public double hearing_delay;
    }
}
