namespace RayTracer.Rendering;

/// <summary>Two halves of a picture's samples, which are kept apart beside it: each has every other pass.</summary>
/// <param name="Films">A film for each half.</param>
internal sealed record SampleHalves(IReadOnlyList<Film> Films)
{
    // Samples of both halves together.
    private const int LongestTurns = 128;

    /// <summary>
    /// Returns the half that a sample belongs to, and where its turn ends. Turns become longer, so that both halves have samples soon, and
    /// yet there are few; they do not depend on how long passes take.
    /// </summary>
    /// <param name="first">The sample.</param>
    /// <param name="all">All samples.</param>
    public static (int Half, int End) Turn(int first, SampleRange all)
    {
        int since = first - all.First;
        int begin = since < 2 ? 0 : since < LongestTurns ? 1 << int.Log2(since) : since / LongestTurns * LongestTurns;
        int end = Math.Min(all.Count, begin + Math.Clamp(begin, 2, LongestTurns));
        int middle = (begin + end + 1) / 2;
        return since < middle ? (0, all.First + middle) : (1, all.First + end);
    }
}
