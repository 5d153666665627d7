using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.InteropServices;

namespace Mimo
{
    /// <summary>The observations, actions and reward terms of a world, of attached senses, or of each world of a batch.
    /// It never changes, except Field.Start and Field.End after a reset to another age.</summary>
    public sealed class Layout
    {
        private readonly LayoutHandle handle;

        /// <summary>The sizes of one world.</summary>
        public LayoutInfo Info { get; }

        /// <summary>Size of an observation block.</summary>
        public int BlockBytes { get { return Info.BlockBytes; } }

        /// <summary>Number of agents.</summary>
        public int Agents { get { return Info.Agents; } }

        /// <summary>The fields of the block.</summary>
        public IReadOnlyList<Field> Fields { get; }

        /// <summary>The actions of all agents.</summary>
        public IReadOnlyList<MimoAction> Actions { get; }

        /// <summary>The reward terms of all agents, in the order of Env.Terms.</summary>
        public IReadOnlyList<Term> Terms { get; }

        internal delegate int LayoutCall(out IntPtr layout);

        internal Layout(SafeHandle owner, LayoutCall ask)
        {
            IntPtr lent;
            MimoException.Check(ask(out lent));
            handle = new LayoutHandle(lent, owner);
            var info = LayoutInfoStruct.New();
            MimoException.Check(Native.mimo_layout_describe(handle, ref info));
            Info = new LayoutInfo(info);
            Fields = All(info.fields, index => new Field(handle, index));
            Actions = All(info.actions, index => ActionAt(index));
            Terms = All(info.terms, index => TermAt(index));
        }

        private MimoAction ActionAt(UIntPtr index)
        {
            var raw = ActionStruct.New();
            MimoException.Check(Native.mimo_layout_action(handle, index, ref raw));
            return new MimoAction(raw);
        }

        private Term TermAt(UIntPtr index)
        {
            var raw = TermStruct.New();
            MimoException.Check(Native.mimo_layout_term(handle, index, ref raw));
            return new Term(raw);
        }

        internal void Renew()
        {
            foreach (var field in Fields) field.Renew();
        }

        private static T[] All<T>(UIntPtr count, Func<UIntPtr, T> byIndex)
        {
            return Enumerable.Range(0, (int)count).Select(index => byIndex((UIntPtr)(uint)index)).ToArray();
        }

        /// <summary>The field with that name.</summary>
        public Field Find(string name)
        {
            UIntPtr index;
            MimoException.Check(Native.mimo_layout_find(handle, Utf8.Bytes(name), out index));
            return Fields[(int)index];
        }

        /// <summary>The index of an agent's reward term in Terms and Env.Terms.</summary>
        public int FindTerm(string name, int agent = 0)
        {
            for (var i = 0; i < Terms.Count; ++i)
                if (Terms[i].Name == name && Terms[i].Agent == agent) return i;
            throw new ArgumentException("no term \"" + name + "\" of agent " + agent + "; there are: " +
                string.Join(", ", Terms.Select(term => term.Name + " of " + term.Agent)), nameof(name));
        }
    }

}
