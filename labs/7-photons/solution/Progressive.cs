namespace Lab7;

/// <summary>Many small maps instead of a large one (Knaus and Zwicker, Progressive photon mapping: a probabilistic approach, 2011).</summary>
public static class Progressive
{
    /// <summary>The radius of the next map: the mean of all becomes right if the circles shrink, but not too fast.</summary>
    /// <param name="radius">The radius of this map.</param>
    /// <param name="map">The number of this map, from 1.</param>
    /// <param name="kept">The share of its photons that a circle keeps in the long run: between 0 and 1.</param>
    public static double NextRadius(double radius, int map, double kept)
    {
        //? Progressive.NextRadius: the area of the circle shrinks by (map + kept) / (map + 1).
        return radius * Math.Sqrt((map + kept) / (map + 1));
        //!
    }
}
