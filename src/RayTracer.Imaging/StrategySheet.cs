using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>
/// What each way to make paths brings to a picture, as the pyramid of Veach 1997, figure 10.4: from row to row paths have an edge more, from column to
/// column the light a vertex more; above with their weights, below alone. Rows are brightened as he does, so that those of long paths show something.
/// </summary>
internal static class StrategySheet
{
    private const int WidestCell = 240;
    private const int MostStops = 12;

    // √2: stops are rounded.
    private const double HalfStop = 1.41421356;

    /// <summary>Draws the sheet.</summary>
    /// <param name="film">The light of each way.</param>
    /// <param name="shown">The exposure and tone map of the picture.</param>
    public static Picture Draw(StrategyFilm film, ImageWriteOptions shown)
    {
        IImageRows any = film.Layers.First().Image;
        int width = Math.Min(any.Width, WidestCell);
        int height = Math.Max(1, (int)((long)any.Height * width / any.Width));
        int most = film.Strategies.Max(s => s.Edges);
        Dictionary<(PathStrategy, bool), Picture> cells = film.Strategies.SelectMany(s => new[] { (s, true), (s, false) })
            .ToDictionary(c => c, c => ScaledRows.Shrink(film.Image(c.s, c.Item2), width, height));
        int[] stops = Stops(cells, most);
        bool[] kinds = [.. film.Strategies.Select(s => s.IsMerge).Distinct()];
        ContactSheet sheet = new(
            new("vertices from the light", [.. Enumerable.Range(0, most + 1).Select(s => $"s = {s}")]),
            new("edges", [.. stops.Select((stop, k) => stop == 0 ? $"{k + 1}" : $"{k + 1}, {stop:+0;-0} EV")]),
            new("each way", [.. kinds.SelectMany(isMerge => new[] { "weighted", "alone" }, (isMerge, how) => isMerge ? $"{how}, merged" : how)]),
            width,
            height);
        foreach (((PathStrategy way, bool isWeighted), Picture cell) in cells)
        {
            ToneMappedRows rows = new(cell, shown.ToneMap ?? Description.ToneMap.Clamp, (shown.Exposure ?? default).StopsFor(cell) + stops[way.Edges - 1]);
            sheet.Place(rows, way.Light, way.Edges - 1, (2 * Array.IndexOf(kinds, way.IsMerge)) + (isWeighted ? 0 : 1));
        }

        return sheet.Picture;
    }

    // Of each length of paths: how much brighter all that is brought by paths of two edges is, in whole stops.
    private static int[] Stops(Dictionary<(PathStrategy Way, bool IsWeighted), Picture> cells, int most)
    {
        double[] light = [.. Enumerable.Range(1, most).Select(k => cells.Where(c => c.Key.IsWeighted && c.Key.Way.Edges == k).Sum(c => c.Value.Pixels.Sum(v => (double)v)))];
        double goal = light[Math.Min(1, most - 1)];
        return [.. light.Select((own, i) => i < 2 || !(own > 0 && goal > 0) ? 0 : Math.Clamp(Math.ILogB(goal / own * HalfStop), 0, MostStops))];
    }
}
