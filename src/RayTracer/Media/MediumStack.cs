using RayTracer.Numerics;

namespace RayTracer.Media;

/// <summary>
/// The media that a path is in, in one integer: three numbers of eight bits, the innermost one lowest, 0 for none; and above them how many boundaries
/// the path has crossed since it last scattered.
/// </summary>
internal static class MediumStack
{
    /// <summary>The most media of a scene.</summary>
    public const int MaxMedia = 255;

    private const uint Media = 0xffffff;
    private const int CountShift = 24;

    /// <summary>The innermost medium.</summary>
    public static UIntW Innermost(UIntW stack) => stack & 0xffu;

    /// <summary>The number of boundaries that were crossed.</summary>
    public static UIntW Crossings(UIntW stack) => stack >> CountShift;

    /// <summary>The stack after a boundary: of four media within each other, the outermost one is forgotten.</summary>
    /// <param name="stack">The stack.</param>
    /// <param name="medium">Number of the medium behind the boundary.</param>
    /// <param name="crosses">The lanes in which the boundary is crossed.</param>
    /// <param name="enters">True if that is inwards.</param>
    public static UIntW Cross(UIntW stack, uint medium, MaskW crosses, MaskW enters)
    {
        UIntW media = stack & Media;
        UIntW entered = ((media << 8) | medium) & Media;

        // What is left may be the innermost medium, or, where shapes overlap, one around it.
        MaskW isFirst = UIntW.Equal(media & 0xffu, medium);
        MaskW isSecond = UIntW.Equal((media >> 8) & 0xffu, medium);
        MaskW isThird = UIntW.Equal(media >> 16, medium);
        UIntW left = isFirst.Select(media >> 8, isSecond.Select((media & 0xffu) | ((media >> 16) << 8), isThird.Select(media & 0xffffu, media)));
        UIntW crossings = Crossings(stack) + 1u;
        crossings = (crossings > 0xffu).Select(0xffu, crossings);
        return crosses.Select(enters.Select(entered, left) | (crossings << CountShift), stack);
    }

    /// <summary>
    /// As <see cref="Cross"/>, with priorities: the media are kept by falling priority, and what enters comes before those of its own
    /// (Schmidt &amp; Budge 2002, with the list of interiors sorted).
    /// </summary>
    /// <param name="stack">The stack.</param>
    /// <param name="medium">Number of the medium behind the boundary.</param>
    /// <param name="crosses">The lanes in which the boundary is crossed.</param>
    /// <param name="enters">True if that is inwards.</param>
    /// <param name="priorities">The priorities of the media by number, of which that of number 0 is below all others.</param>
    public static unsafe UIntW CrossByPriority(UIntW stack, uint medium, MaskW crosses, MaskW enters, float* priorities)
    {
        UIntW media = stack & Media;
        FloatW own = priorities[medium];
        MaskW beforeFirst = own >= Rank(priorities, media & 0xffu);
        MaskW beforeSecond = own >= Rank(priorities, (media >> 8) & 0xffu);
        MaskW beforeThird = own >= Rank(priorities, media >> 16);
        UIntW first = media & 0xffu;
        UIntW two = media & 0xffffu;
        UIntW entered = beforeFirst.Select(
            ((media << 8) | medium) & Media,
            beforeSecond.Select(first | (medium << 8) | (((media >> 8) & 0xffu) << 16), beforeThird.Select(two | (medium << 16), media)));

        // What leaves is taken out wherever it is; and so the way in is the plain one for what comes first anyway.
        UIntW plain = Cross(stack, medium, crosses, enters);
        return (crosses & enters).Select((plain & ~Media) | entered, plain);
    }

    // What has no priority gives way to whatever enters it.
    private static unsafe FloatW Rank(float* priorities, UIntW medium)
    {
        FloatW priority = FloatW.Gather(priorities, medium);
        return (priority < float.MaxValue).Select(priority, -1f);
    }

    /// <summary>The stack with no boundary crossed since.</summary>
    public static UIntW Scattered(UIntW stack) => stack & Media;
}
