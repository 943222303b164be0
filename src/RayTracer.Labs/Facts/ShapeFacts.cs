using RayTracer.Textbook;

namespace RayTracer.Labs;

/// <summary>
/// Facts about an <see cref="IShape"/>. Most of them compare the shape with itself: a line meets the same points from both ends, and neighbouring points
/// span the plane across the normal. The area is compared with lines in all directions, of which every unit of area meets as many (Crofton 1868).
/// </summary>
/// <param name="shape">The shape.</param>
/// <param name="seed">Of the random numbers.</param>
/// <param name="count">The number of lines.</param>
public sealed class ShapeFacts(IShape shape, long seed = 1, int count = 20_000)
{
    /// <summary>Rays meet the shape, where it is.</summary>
    public const string Hits = "hits lie on the ray and in the box";

    /// <summary>The distance counts the direction's length.</summary>
    public const string Lengths = "distances count the length of the direction";

    /// <summary>What is farther than the nearest hit so far changes nothing.</summary>
    public const string Limits = "what is hidden changes nothing";

    /// <summary>A line meets the same points from both ends.</summary>
    public const string BothEnds = "a line meets the same points from both ends";

    /// <summary>Normals are of length 1 and perpendicular to the surface.</summary>
    public const string Normals = "normals are perpendicular to the surface";

    /// <summary>Normals of closed shapes point outwards.</summary>
    public const string Outwards = "normals point outwards";

    /// <summary>The area is that of the surface.</summary>
    public const string SurfaceArea = "the area is that of the surface";

    /// <summary>Random points lie on the surface and follow their pdf.</summary>
    public const string Points = "random points follow their pdf";

    /// <summary>Directions to random points follow their pdf.</summary>
    public const string Seen = "directions to random points follow their pdf";

    // Rays that pass an edge by rounding, or nearly touch, may go either way.
    private const double Doubtful = 2e-3;
    private const double Grazing = 0.02;
    private readonly Bounds _box = shape.Bounds.IsFinite ? shape.Bounds : new(new(-3, -3, -3), new(3, 3, 3));

    private Vector Middle => _box.Middle;

    private double Radius => (0.5 * _box.Size.Length) + 1e-9;

    /// <summary>Checks all of them.</summary>
    public IReadOnlyList<Fact> All()
    {
        List<Fact> facts =
        [
            Most(Hits, "Hits lie on their rays and in the box.", HitOf),
            Most(Lengths, "Twice as long a direction halves the distance.", LengthOf),
            Most(Limits, "What is farther than the nearest hit so far changes nothing.", LimitOf),
            Most(BothEnds, "Lines meet the same points from both ends.", BothEndsOf),
            Most(Normals, "Normals have length 1 and are perpendicular to the surface.", NormalOf),
            Most(Outwards, "Rays go in where they come against the normal, and out along it.", OutwardsOf),
        ];
        if (shape.Bounds.IsFinite && double.IsFinite(shape.Area))
        {
            facts.Add(Fact.Of(SurfaceArea, "Lines meet the surface as often as its area says.", ["all lines"], _ => AreaOf()));
            facts.Add(Fact.Of(Points, "Random points lie on the surface, as dense as their pdf says.", ["all points"], _ => PointsOf()));
            facts.Add(Fact.Of(Seen, "Directions to random points are as dense as their pdf says.", new[] { 2.5, 1.3 }, SeenFrom));
        }

        return facts;
    }

    // Holds where nearly all lines agree; the first that does not is the case that is shown.
    private Fact Most(string name, string good, Func<Ray, Fact?> check) => Fact.Of(name, good, [0], _ =>
    {
        Fact? first = null;
        int wrong = 0;
        int met = 0;
        foreach (Ray line in Lines(count / 4))
        {
            Hit hit = Hit.None();
            met += shape.Intersect(line, ref hit) ? 1 : 0;
            if (check(line) is { } fact)
            {
                first ??= fact with { Case = $"the ray from {Short(line.Origin)} in the direction {Short(line.Direction)}" };
                wrong++;
            }
        }

        return met == 0 ? Fact.Wrong("None of the rays through the box around it meets the shape.", double.NaN, 0, $"rays from around {Short(Middle)}")
            : wrong > Doubtful * met ? first! with { Sentence = $"{first.Sentence} ({wrong} of {met} rays that meet the shape)" } : null;
    });

    private Fact? HitOf(Ray line)
    {
        if (First(line) is not { } hit)
        {
            return null;
        }

        double off = (hit.Point - line.At(hit.Distance)).Length;
        Vector outside = Vector.Max(shape.Bounds.Low - hit.Point, hit.Point - shape.Bounds.High);
        double beyond = Math.Max(outside.X, Math.Max(outside.Y, outside.Z));
        return !(off <= 1e-6 * Radius) ? Fact.Wrong($"Describe gives the point {Short(hit.Point)}, but the ray is at {Short(line.At(hit.Distance))} at that distance.", 0, off)
            : beyond > 1e-6 * Radius ? Fact.Wrong($"The point {Short(hit.Point)} is {Fact.Text(beyond)} outside of Bounds: a tree will not find it.", 0, beyond)
            : null;
    }

    private Fact? LengthOf(Ray line)
    {
        double once = First(line)?.Distance ?? double.PositiveInfinity;
        double twice = First(line with { Direction = 2 * line.Direction })?.Distance ?? double.PositiveInfinity;
        return once == 2 * twice || Math.Abs(once - (2 * twice)) < 1e-6 * once ? null : Fact.Wrong(
            $"The distance is {Fact.Text(once)}; with a direction of length 2 it must be half of that, but is {Fact.Text(twice)}. Shapes that are moved and stretched see such directions.", once / 2, twice);
    }

    private Fact? LimitOf(Ray line)
    {
        if (First(line) is not { } hit)
        {
            return null;
        }

        Hit nearer = Hit.None(hit.Distance * (1 - 1e-6));
        Hit farther = Hit.None(hit.Distance * (1 + 1e-6));
        double limit = nearer.Distance;
        return shape.Intersect(line, ref nearer) || nearer.Distance != limit
            ? Fact.Wrong($"Something nearer was found before, at {Fact.Text(limit)}, but Intersect took {Fact.Text(hit.Distance)}.", limit, nearer.Distance)
            : !shape.Intersect(line, ref farther) ? Fact.Wrong($"The hit at {Fact.Text(hit.Distance)} is missed where the nearest so far is a little farther.") : null;
    }

    private Fact? BothEndsOf(Ray line)
    {
        Vector end = line.At(2 * Vector.Dot(Middle - line.Origin, line.Direction));
        List<Hit> there = Crossings(line).FindAll(IsBetween);
        List<Hit> back = Crossings(new(end, -line.Direction)).FindAll(IsBetween);
        bool IsBetween(Hit hit) => (hit.Point - Middle).Length < 1.1 * Radius;
        if (there.Concat(back).Any(h => Math.Abs(Vector.Dot(h.Normal, line.Direction)) < Grazing))
        {
            return null;
        }

        Hit? lone = there.Where(h => !back.Exists(b => (b.Point - h.Point).Length < 1e-5 * Radius)).Select(h => (Hit?)h).FirstOrDefault()
            ?? back.Where(h => !there.Exists(b => (b.Point - h.Point).Length < 1e-5 * Radius)).Select(h => (Hit?)h).FirstOrDefault();
        return lone is null ? null : Fact.Wrong(
            $"The line meets the shape at {Short(lone.Value.Point)} from one end only: {there.Count} points from here, {back.Count} from the other end. A ray that starts inside must find the far side.",
            there.Count, back.Count);
    }

    private Fact? NormalOf(Ray line)
    {
        if (First(line) is not { } hit)
        {
            return null;
        }

        if (!(Math.Abs(hit.Normal.Length - 1) < 1e-6))
        {
            return Fact.Wrong($"The normal at {Short(hit.Point)} is {Short(hit.Normal)}, whose length is not 1.", 1, hit.Normal.Length);
        }

        double step = 1e-4 * Radius;
        Frame across = new(line.Direction);
        foreach (Vector beside in new[] { across.ToWorld(new(step, 0, 0)), across.ToWorld(new(0, step, 0)) })
        {
            if (First(line with { Origin = line.Origin + beside }) is not { } near || near.Part != hit.Part || Vector.Dot(near.Normal, hit.Normal) < 0.99)
            {
                continue;
            }

            // The mean of both normals is across the chord, as far as the surface is a circle's.
            Vector chord = near.Point - hit.Point;
            double sine = Vector.Dot(chord, near.Normal + hit.Normal) / (2 * chord.Length);
            if (chord.Length < 100 * step && Math.Abs(sine) > 0.01)
            {
                return Fact.Wrong(
                    $"The normal at {Short(hit.Point)} is {Short(hit.Normal)}, but the surface goes on to {Short(near.Point)}, {Fact.Text(Math.Abs(Math.Asin(sine)) * 180 / Math.PI)}° off the plane across it.", 0, sine);
            }
        }

        return null;
    }

    // Of a closed shape: lines that go in come out.
    private Fact? OutwardsOf(Ray line)
    {
        List<Hit> met = Crossings(line);
        if (met.Count % 2 != 0 || !IsClosed || met.Exists(h => Math.Abs(Vector.Dot(h.Normal, line.Direction)) < Grazing))
        {
            return null;
        }

        int wrong = met.FindIndex(h => Vector.Dot(h.Normal, line.Direction) < 0 != (met.IndexOf(h) % 2 == 0));
        return wrong < 0 ? null : Fact.Wrong(
            $"The line goes {(wrong % 2 == 0 ? "in" : "out")} at {Short(met[wrong].Point)}, but the normal there, {Short(met[wrong].Normal)}, points {(wrong % 2 == 0 ? "inwards" : "to where it comes from")}.");
    }

    private bool IsClosed => _isClosed ??= Lines(500).Select(Crossings).Count(c => c.Count % 2 != 0) <= 5;

    private bool? _isClosed;

    private Fact? AreaOf()
    {
        double[] crossings = [.. Lines(count).Select(l => (double)Crossings(l).Count)];
        double scale = 2 * Math.PI * Radius * Radius;
        double mean = crossings.Average();
        double area = mean * scale;
        double spread = Math.Sqrt(crossings.Sum(c => (c - mean) * (c - mean))) / count * scale;
        return Math.Abs(area - shape.Area) <= (Histogram.MostDeviations * spread) + (1e-3 * area) ? null
            : Fact.Wrong($"Area is {Fact.Text(shape.Area)}, but lines in all directions find {Fact.Text(area)} (±{Fact.Text(spread)}).", area, shape.Area);
    }

    private Fact? PointsOf()
    {
        IndependentSampler sampler = Sampler(4);
        SurfacePoint[] points = [.. Enumerable.Range(0, count).Select(_ => shape.PointAt(sampler.Next2()))];
        Fact?[] wrong = [.. points.Select(p => PointOf(p, sampler)).Where(f => f is not null)];
        if (wrong.Length > Doubtful * count)
        {
            return wrong[0];
        }

        // Points where lines meet the shape are uniform: of those, as many are kept as the pdf says.
        Hit[] met = [.. Lines(4 * count).SelectMany(Crossings)];
        double most = met.Max(h => shape.PointPdf(h));
        (double, double)[] others = [.. met.Where(h => sampler.Next() * most < shape.PointPdf(h)).Select(h => Place(h.Point, h.Normal))];
        Histogram found = Histogram.OfTwo(_faces, [.. points.Select(p => Place(p.Point, p.Normal))], others);
        return found.Fits ? null : Fact.Wrong(
            $"Random points are not as dense as their pdf says: in one cell there were {found.Worst.Observed:F0}, and {found.Worst.Expected:F0} were expected.",
            found.Worst.Expected, found.Worst.Observed, "the cell that is farthest off") with
        {
            Drawing = found.Draw("Random points, seen from the front (left half) and from behind (right half)", "along the shape", "across"),
        };
    }

    private Fact? PointOf(in SurfacePoint point, ISampler sampler)
    {
        // From a little above, not too flat.
        double height = 0.01 * Radius;
        Vector above = new Frame(point.Normal).ToWorld(Warp.Cone(sampler.Next2(), 0.5));
        Ray ray = new(point.Point + (height * above), -above);
        string at = $"the random point {Short(point.Point)}";
        if (First(ray) is not { } hit || hit.Distance > height * (1 + 1e-4))
        {
            return Fact.Wrong("PointAt gives a point at which no ray meets the shape.", double.NaN, double.NaN, at);
        }

        return hit.Distance < height * (1 - 1e-4) ? null
            : (hit.Normal - point.Normal).Length > 1e-3
                ? Fact.Wrong($"The normal of PointAt is {Short(point.Normal)}, and that of a ray's hit {Short(hit.Normal)}.", double.NaN, double.NaN, at)
            : Math.Abs(shape.PointPdf(hit) - point.Pdf) > 1e-3 * point.Pdf
                ? Fact.Wrong($"PointAt says that its density is {Fact.Text(point.Pdf)}, but PointPdf there is {Fact.Text(shape.PointPdf(hit))}.", shape.PointPdf(hit), point.Pdf, at)
            : null;
    }

    private Fact? SeenFrom(double distance)
    {
        Vector from = Middle + (distance * Radius * new Vector(0.48, 0.6, 0.64));
        string at = $"seen from {Short(from)}";
        IndependentSampler sampler = Sampler(5);
        Fact? first = null;
        int wrong = 0;

        // One over the density, summed over a part of the sky, is the solid angle of what is seen of the shape there.
        ((double, double), double)? Sample()
        {
            (SurfacePoint point, double pdf) = shape.PointSeenFrom(from, sampler.Next2());
            Vector to = point.Point - from;
            if (!(pdf > 0) || First(new(from, to.Unit)) is not { } hit || Math.Abs(hit.Distance - to.Length) > 1e-5 * Radius)
            {
                return null;
            }

            double stated = shape.SeenPdf(from, hit);
            if (Math.Abs(stated - pdf) > 1e-2 * pdf)
            {
                wrong++;
                first ??= Fact.Wrong($"PointSeenFrom says that its density is {Fact.Text(pdf)}, but SeenPdf of the same direction is {Fact.Text(stated)}.", stated, pdf, at);
            }

            return (Area.Of(to.Unit), 1 / pdf);
        }

        Histogram found = Histogram.OfWeights(
            Area.Directions, Sample, (azimuth, cosine) => First(new(from, Area.Direction(azimuth, cosine))) is { } hit && shape.SeenPdf(from, hit) > 0 ? 1 : 0, count);
        return wrong > Doubtful * count ? first : found.Fits ? null : Fact.Wrong(
            $"By the densities of PointSeenFrom, the shape fills {Fact.Text(found.Share)} steradians; by rays, {Fact.Text(found.Integral)}. {Hints.OfPdf(found.Integral / found.Share)}",
            found.Integral, found.Share, at) with
        {
            Drawing = found.Draw($"One over the densities of directions to random points, {at}", "azimuth", "cosine"),
        };
    }

    private Hit? First(in Ray ray)
    {
        Hit hit = Hit.None();
        if (!shape.Intersect(ray, ref hit))
        {
            return null;
        }

        shape.Describe(ray, ref hit);
        return hit;
    }

    // All points of a line, each found from a little behind the one before.
    private List<Hit> Crossings(Ray line)
    {
        List<Hit> all = [];
        while (all.Count < 64 && First(line) is { } hit)
        {
            all.Add(hit);
            line = line with { Origin = line.At(hit.Distance) + (1e-7 * Radius * line.Direction) };
        }

        return all;
    }

    // Lines in all directions through the ball around the shape, each unit of area across them alike.
    private IEnumerable<Ray> Lines(int number)
    {
        IndependentSampler sampler = Sampler(1);
        for (int i = 0; i < number; i++)
        {
            Vector direction = Warp.Sphere(sampler.Next2());
            (double x, double y) = Warp.Disk(sampler.Next2());
            yield return new(Middle + new Frame(direction).ToWorld(new(x * Radius, y * Radius, -2 * Radius)), direction);
        }
    }

    private IndependentSampler Sampler(int stream)
    {
        IndependentSampler sampler = new(seed);
        sampler.Begin(stream, 0, 0);
        return sampler;
    }

    // A place on the face that is seen along the shortest axis: from 0 to 1 from the front, from 1 to 2 from behind.
    private static readonly Area _faces = new(-0.01, 2.01, -0.01, 1.01);

    private (double X, double Y) Place(Vector point, Vector normal)
    {
        int[] axes = [.. Enumerable.Range(0, 3).OrderByDescending(a => _box.Size[a])];
        double On(int axis) => (point[axis] - _box.Low[axis]) / Math.Max(_box.Size[axis], 1e-9 * Radius);
        return ((normal[axes[2]] >= -1e-9 ? 0 : 1) + On(axes[0]), On(axes[1]));
    }

    private static string Short(Vector v) => $"({Fact.Text(v.X)}, {Fact.Text(v.Y)}, {Fact.Text(v.Z)})";
}
