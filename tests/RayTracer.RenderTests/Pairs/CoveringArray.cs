namespace RayTracer.RenderTests.Pairs;

/// <summary>
/// Rows of choices, one choice a factor, in which every two choices of different factors stand together somewhere: made greedily, each row
/// around a pair that is still missing (after Cohen et al. 1997).
/// </summary>
/// <param name="Rows">The rows: for each factor, which of its levels.</param>
internal sealed record CoveringArray(IReadOnlyList<IReadOnlyList<int>> Rows)
{
    /// <summary>Covers all pairs of levels.</summary>
    /// <param name="levels">For each factor, how many levels it has.</param>
    public static CoveringArray Of(IReadOnlyList<int> levels)
    {
        HashSet<(int Factor, int Level, int OtherFactor, int OtherLevel)> missing = [.. Pairs(levels)];
        List<IReadOnlyList<int>> rows = [];
        while (missing.Count > 0)
        {
            int[] row = [.. levels.Select(_ => -1)];
            (int f, int l, int g, int m) = missing.Min();
            (row[f], row[g]) = (l, m);
            foreach (int factor in Enumerable.Range(0, row.Length).Where(i => row[i] < 0))
            {
                // Of equally good levels, another one in each row.
                row[factor] = Enumerable.Range(0, levels[factor]).Select(i => (i + rows.Count) % levels[factor])
                    .MaxBy(level => Enumerable.Range(0, row.Length)
                        .Count(other => row[other] >= 0 && missing.Contains(Pair(factor, level, other, row[other]))));
            }

            missing.ExceptWith(PairsOf(row));
            rows.Add(row);
        }

        return new(rows);
    }

    /// <summary>All pairs of levels of different factors.</summary>
    public static IEnumerable<(int Factor, int Level, int OtherFactor, int OtherLevel)> Pairs(IReadOnlyList<int> levels) =>
        from f in Enumerable.Range(0, levels.Count)
        from g in Enumerable.Range(f + 1, levels.Count - f - 1)
        from l in Enumerable.Range(0, levels[f])
        from m in Enumerable.Range(0, levels[g])
        select (f, l, g, m);

    /// <summary>The pairs of a row.</summary>
    public static IEnumerable<(int Factor, int Level, int OtherFactor, int OtherLevel)> PairsOf(IReadOnlyList<int> row) =>
        from f in Enumerable.Range(0, row.Count)
        from g in Enumerable.Range(f + 1, row.Count - f - 1)
        select (f, row[f], g, row[g]);

    private static (int Factor, int Level, int OtherFactor, int OtherLevel) Pair(int f, int l, int g, int m) =>
        f < g ? (f, l, g, m) : (g, m, f, l);
}
