namespace RayTracer.Description;

/// <summary>The distance between two words, on which "did you mean" is based.</summary>
internal static class EditDistance
{
    /// <summary>
    /// The least number of insertions, deletions, changes and swaps of neighbours between two words, where no part is
    /// edited twice (Damerau 1964; optimal string alignment). Takes time and memory in proportion to the product of the lengths.
    /// </summary>
    /// <param name="a">One word.</param>
    /// <param name="b">The other word.</param>
    public static int Between(string a, string b)
    {
        int[,] d = new int[a.Length + 1, b.Length + 1];
        for (int i = 0; i <= a.Length; i++)
        {
            for (int j = 0; j <= b.Length; j++)
            {
                d[i, j] = i == 0 || j == 0 ? i + j : Math.Min(
                    Math.Min(d[i - 1, j], d[i, j - 1]) + 1, d[i - 1, j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1));
                if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                {
                    d[i, j] = Math.Min(d[i, j], d[i - 2, j - 2] + 1);
                }
            }
        }

        return d[a.Length, b.Length];
    }
}
