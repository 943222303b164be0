namespace Lab4;

/// <summary>
/// Light that comes straight to a matt surface from lamps, with nothing in between. A Place has a Point, a unit Normal and an Albedo (the share of light that it
/// reflects). FromPoint to FromBall return the radiance that leaves it: albedo/π times the irradiance.
/// </summary>
public static class Lights
{
    /// <summary>A lamp without extent: intensity over the squared distance, times the cosine.</summary>
    /// <param name="place">The place that is lit.</param>
    /// <param name="lamp">Where the lamp is.</param>
    /// <param name="intensity">Its power per steradian.</param>
    public static double FromPoint(Place place, Vector lamp, double intensity)
    {
        //? Lights.FromPoint: albedo/π · intensity · cosine / distance²; nothing comes from behind the surface.
        Vector to = lamp - place.Point;
        double cosine = Vector.Dot(to.Unit, place.Normal);
        return cosine > 0 ? place.Albedo / Math.PI * intensity * cosine / Vector.Dot(to, to) : 0;
        //!
    }

    /// <summary>All of N lamps: no noise, but N times the work.</summary>
    /// <param name="place">The place.</param>
    /// <param name="lamps">The lamps, all of the same intensity.</param>
    /// <param name="intensity">The intensity of each.</param>
    public static double FromAll(Place place, IReadOnlyList<Vector> lamps, double intensity)
    {
        //? Lights.FromAll: the sum over all lamps.
        double sum = 0;
        foreach (Vector lamp in lamps)
        {
            sum += FromPoint(place, lamp, intensity);
        }

        return sum;
        //!
    }

    /// <summary>One of N lamps, at random: an estimate of <see cref="FromAll"/>.</summary>
    /// <param name="place">The place.</param>
    /// <param name="lamps">The lamps.</param>
    /// <param name="intensity">The intensity of each.</param>
    /// <param name="random">The source of random numbers.</param>
    public static double FromOne(Place place, IReadOnlyList<Vector> lamps, double intensity, ISampler random)
    {
        //? Lights.FromOne: choose one lamp, and divide by the probability of that.
        int chosen = (int)(random.Next() * lamps.Count);
        return lamps.Count * FromPoint(place, lamps[chosen], intensity);
        //!
    }

    /// <summary>A random point of a rectangular lamp: an estimate of the light of all its points.</summary>
    /// <param name="place">The place.</param>
    /// <param name="lamp">The lamp: a Corner, two perpendicular edges EdgeU and EdgeV, its Normal, its Area, and its Radiance, on the side of the normal.</param>
    /// <param name="random">Two random numbers from 0 to 1.</param>
    public static double FromRectangle(Place place, Panel lamp, (double U, double V) random)
    {
        //? Lights.FromRectangle: a uniform point; albedo/π · radiance · cosine here · cosine there / distance², over the density 1/area.
        Vector point = lamp.Corner + (random.U * lamp.EdgeU) + (random.V * lamp.EdgeV);
        Vector to = point - place.Point;
        Vector direction = to.Unit;
        double here = Vector.Dot(direction, place.Normal);
        double there = -Vector.Dot(direction, lamp.Normal);
        return here > 0 && there > 0 ? place.Albedo / Math.PI * lamp.Radiance * here * there * lamp.Area / Vector.Dot(to, to) : 0;
        //!
    }

    /// <summary>The mean of <see cref="FromRectangle"/> over side × side points, one in each part of the lamp.</summary>
    /// <param name="place">The place.</param>
    /// <param name="lamp">The lamp.</param>
    /// <param name="side">The number of parts along each edge.</param>
    /// <param name="random">The source of random numbers.</param>
    public static double FromStrata(Place place, Panel lamp, int side, ISampler random)
    {
        //? Lights.FromStrata: a random point in each of side × side parts of the lamp, and the mean.
        double sum = 0;
        for (int i = 0; i < side; i++)
        {
            for (int j = 0; j < side; j++)
            {
                sum += FromRectangle(place, lamp, ((i + random.Next()) / side, (j + random.Next()) / side));
            }
        }

        return sum / (side * side);
        //!
    }

    /// <summary>The solid angle in which a ball is seen.</summary>
    /// <param name="distance">The distance to its centre.</param>
    /// <param name="radius">Its radius, which is smaller.</param>
    public static double SolidAngle(double distance, double radius)
    {
        //? Lights.SolidAngle: 2π · (1 − cos θ), with θ the angle between the centre and the rim.
        double sin2 = radius * radius / (distance * distance);
        return 2 * Math.PI * (1 - Math.Sqrt(1 - sin2));
        //!
    }

    /// <summary>A random direction in which a shining ball is seen: an estimate of all its light, with a density that is uniform over its solid angle.</summary>
    /// <param name="place">The place, outside of the ball.</param>
    /// <param name="ball">The ball: its Center, its Radius, and its Radiance.</param>
    /// <param name="random">Two random numbers from 0 to 1.</param>
    public static double FromBall(Place place, Ball ball, (double U, double V) random)
    {
        //? Lights.FromBall: a uniform direction of the cone; albedo/π · radiance · cosine · solid angle.
        Vector direction = InCone(place, ball, random);
        double cosine = Vector.Dot(direction, place.Normal);
        double solidAngle = SolidAngle((ball.Center - place.Point).Length, ball.Radius);
        return cosine > 0 ? place.Albedo / Math.PI * ball.Radiance * cosine * solidAngle : 0;
        //!
    }

    /// <summary>A direction in the cone in which a ball is seen, uniformly.</summary>
    /// <param name="place">The place, outside of the ball.</param>
    /// <param name="ball">The ball.</param>
    /// <param name="random">Two random numbers from 0 to 1.</param>
    /// <returns>A unit vector.</returns>
    public static Vector InCone(Place place, Ball ball, (double U, double V) random)
    {
        //? Lights.InCone: heights are uniform between the cosine of the rim and 1; turn the cone to the ball with a Frame.
        Vector to = ball.Center - place.Point;
        double distance = to.Length;
        double z = 1 - (random.V * SolidAngle(distance, ball.Radius) / (2 * Math.PI));
        double sin = Math.Sqrt(Math.Max(0, 1 - (z * z)));
        double angle = 2 * Math.PI * random.U;
        return new Frame(to.Unit).ToWorld(new(sin * Math.Cos(angle), sin * Math.Sin(angle), z));
        //!
    }

    /// <summary>The share of a way to find light that another way finds too: the power heuristic (Veach 1997, section 9.2).</summary>
    /// <param name="own">The density of this way, per steradian.</param>
    /// <param name="other">The density of the other way, of the same direction.</param>
    public static double Share(double own, double other)
    {
        //? Lights.Share: own² over the sum of both squares.
        return own * own / ((own * own) + (other * other));
        //!
    }

    /// <summary>
    /// The light of a ball in a shiny surface, found in two ways at once: one direction towards the ball, and one that the surface's lobe chooses. Each is weighted
    /// by its share. What the surface reflects is the lobe's Value alone: the albedo of the place is not used.
    /// </summary>
    /// <param name="place">The place.</param>
    /// <param name="ball">The ball.</param>
    /// <param name="lobe">The surface: its BSDF · cosine of a direction (Value), the density with which it chooses one (Pdf), and the choice (Choose).</param>
    /// <param name="random">The source of random numbers.</param>
    public static double FromBoth(Place place, Ball ball, Lobe lobe, ISampler random)
    {
        //? Lights.FromBoth: radiance · Value / density, times the share of the way, for each way; the second finds the ball or it does not.
        double solidAngle = SolidAngle((ball.Center - place.Point).Length, ball.Radius);
        Vector atBall = InCone(place, ball, random.Next2());
        double light = ball.Radiance * lobe.Value(atBall) * solidAngle * Share(1 / solidAngle, lobe.Pdf(atBall));
        Vector atLobe = lobe.Choose(random.Next2());
        if (ball.IsMetBy(place.Point, atLobe))
        {
            double pdf = lobe.Pdf(atLobe);
            light += ball.Radiance * lobe.Value(atLobe) / pdf * Share(pdf, 1 / solidAngle);
        }

        return light;
        //!
    }
}
