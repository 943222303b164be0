using System.Globalization;
using RayTracer.Rendering;

namespace RayTracer.Import.Tests;

/// <summary>
/// Metal under a coat, against a random walk through the layers as pbrt does it (Guo, Hašan &amp; Zhao 2018): microfacets of both surfaces are met at random, with the
/// masking of Heitz 2014 for two directions at the same height, and light goes on until it is out, absorbed or lost. Covers `CoatedConductorMaterial`, `PbrtCoats`.
/// </summary>
public class PbrtCoatTests
{
    private const int Walks = 60_000;

    // Roughness (alpha) of the coat and of the metal, thickness, eta and k of the metal, the angle in degrees, and the largest difference, relative to the walk.
    [Theory]
    [InlineData(0, 0, 0.01, 0.2, 3.9, 0, 0.01)]
    [InlineData(0, 0, 0.2, 0.2, 3.9, 70, 0.01)]
    [InlineData(0, 0.1, 0.01, 0.2, 3.9, 0, 0.01)]
    [InlineData(0, 0.1, 0.01, 0.2, 3.9, 60, 0.01)]
    [InlineData(0, 0.3, 0.1, 1.1, 6.8, 0, 0.01)]
    [InlineData(0, 0.3, 0.1, 1.1, 6.8, 60, 0.01)]
    [InlineData(0.1, 0.1, 0.01, 1.1, 6.8, 30, 0.01)]
    [InlineData(0.3, 0.2, 0.01, 0.2, 3.9, 45, 0.01)]
    public void The_same_light_comes_back_as_from_a_walk_through_the_layers(double coat, double metal, double thickness, double eta, double k, double angle, double tolerance)
    {
        (double expected, double error) = Walk(coat, metal, thickness, eta, k, angle);
        double found = Render(coat, metal, thickness, eta, k, angle);
        Assert.True(Math.Abs(found - expected) < (tolerance * expected) + (4 * error), string.Create(CultureInfo.InvariantCulture, $"{found:F4}, but the walk {expected:F4} ± {error:F4}"));
    }

    // Light of radiance 1 all around, so that what is seen is what comes back.
    private static double Render(double coat, double metal, double thickness, double eta, double k, double angle)
    {
        string sine = Math.Sin(angle * Math.PI / 180).ToString(CultureInfo.InvariantCulture);
        string cosine = Math.Cos(angle * Math.PI / 180).ToString(CultureInfo.InvariantCulture);
        string material = string.Create(CultureInfo.InvariantCulture, $"""
            Material "coatedconductor" "bool remaproughness" false "float interface.roughness" {coat} "float conductor.roughness" {metal} "float thickness" {thickness}
                "rgb conductor.eta" [{eta} {eta} {eta}] "rgb conductor.k" [{k} {k} {k}]
            """);
        string before = $"""
            LookAt {sine} 0 {cosine}  0 0 0  0 1 0 Camera "orthographic" "float screenwindow" [-0.1 0.1 -0.1 0.1]
            Film "rgb" "integer xresolution" 8 "integer yresolution" 8 PixelFilter "box" Sampler "zsobol" "integer pixelsamples" 1024 Integrator "path" "integer maxdepth" 2
            """;
        Film film = PbrtTestScene.Render($"LightSource \"infinite\" {material}\nShape \"disk\"", before);
        return Enumerable.Range(0, 64).Average(i => (double)film.Mean(i % 8, i / 8).G);
    }

    private static (double Mean, double Error) Walk(double coat, double metal, double thickness, double eta, double k, double angle)
    {
        Random random = new(2018 + TestSettings.Seed);
        (double sum, double squares) = (0, 0);
        for (int i = 0; i < Walks; i++)
        {
            double kept = OneWalk(random, coat, metal, thickness, eta / Index, k / Index, new(Math.Sin(angle * Math.PI / 180), 0, Math.Cos(angle * Math.PI / 180)));
            (sum, squares) = (sum + kept, squares + (kept * kept));
        }

        double mean = sum / Walks;
        return (mean, Math.Sqrt(((squares / Walks) - (mean * mean)) / Walks));
    }

    private const double Index = 1.5;

    private static double OneWalk(Random random, double coat, double metal, double thickness, double eta, double k, Direction view)
    {
        // At the coat, from outside or inside; w points away from the surface, to where the light came from.
        (double weight, Direction w, bool isOutside) = (1, view, true);
        for (int step = 0; step < 400; step++)
        {
            Direction m = coat < 1e-3 ? new(0, 0, 1) : Facet(random, w, coat);
            double index = isOutside ? Index : 1 / Index;
            double cosine = w.Dot(m);
            double sine2 = (1 - (cosine * cosine)) / (index * index);
            double refracted = Math.Sqrt(Math.Max(1 - sine2, 0));
            bool reflects = sine2 >= 1 || random.NextDouble() < Reflectance(cosine, refracted, index);
            Direction next = reflects ? m.Mirror(w) : new Direction(-w.X / index, -w.Y / index, -w.Z / index) + (m * ((cosine / index) - refracted));
            if (reflects == next.Z <= 0)
            {
                return 0;
            }

            weight *= coat < 1e-3 ? 1 : Shadowing(w, next, coat);
            if (reflects == isOutside)
            {
                return weight;
            }

            // Down to the metal and up again; all in the frame that has what is at hand above.
            Direction down = new(next.X, next.Y, Math.Abs(next.Z));
            weight *= Math.Exp(-thickness / down.Z);
            Direction facet = metal < 1e-3 ? new(0, 0, 1) : Facet(random, Opposite(down), metal);
            Direction from = Opposite(down);
            Direction up = facet.Mirror(from);
            if (up.Z <= 0)
            {
                return 0;
            }

            weight *= Conductor(from.Dot(facet), eta, k) * (metal < 1e-3 ? 1 : Shadowing(from, up, metal)) * Math.Exp(-thickness / up.Z);
            (w, isOutside) = (Opposite(up), false);
        }

        return 0;
    }

    // Where light goes, seen from the surface that it comes to: the direction back.
    private static Direction Opposite(Direction d) => new(-d.X, -d.Y, d.Z);

    private static double Reflectance(double cosine, double refracted, double index)
    {
        double parallel = ((index * cosine) - refracted) / ((index * cosine) + refracted);
        double perpendicular = (cosine - (index * refracted)) / (cosine + (index * refracted));
        return ((parallel * parallel) + (perpendicular * perpendicular)) / 2;
    }

    private static double Conductor(double cosine, double eta, double k)
    {
        System.Numerics.Complex n = new(eta, k);
        System.Numerics.Complex inside = System.Numerics.Complex.Sqrt(1 - ((1 - (cosine * cosine)) / (n * n)));
        System.Numerics.Complex parallel = ((n * cosine) - inside) / ((n * cosine) + inside);
        System.Numerics.Complex perpendicular = (cosine - (n * inside)) / (cosine + (n * inside));
        return ((parallel.Magnitude * parallel.Magnitude) + (perpendicular.Magnitude * perpendicular.Magnitude)) / 2;
    }

    // Heitz 2018: a visible normal of the GGX distribution.
    private static Direction Facet(Random random, Direction w, double alpha)
    {
        Direction stretched = new Direction(alpha * w.X, alpha * w.Y, w.Z).Unit;
        Direction first = stretched.Z < 0.99999 ? new Direction(-stretched.Y, stretched.X, 0).Unit : new(1, 0, 0);
        Direction second = stretched.Cross(first);
        double r = Math.Sqrt(random.NextDouble());
        double phi = 2 * Math.PI * random.NextDouble();
        double x = r * Math.Cos(phi);
        double s = 0.5 * (1 + stretched.Z);
        double y = ((1 - s) * Math.Sqrt(1 - (x * x))) + (s * r * Math.Sin(phi));
        Direction normal = (first * x) + (second * y) + (stretched * Math.Sqrt(Math.Max(1 - (x * x) - (y * y), 0)));
        return new Direction(alpha * normal.X, alpha * normal.Y, Math.Max(normal.Z, 1e-9)).Unit;
    }

    // Of what is seen from one direction, what is seen from the other, on whichever side that is.
    private static double Shadowing(Direction one, Direction other, double alpha) => (1 + Lambda(one, alpha)) / (1 + Lambda(one, alpha) + Lambda(other, alpha));

    private static double Lambda(Direction d, double alpha) => (Math.Sqrt(1 + (alpha * alpha * ((d.X * d.X) + (d.Y * d.Y)) / (d.Z * d.Z))) - 1) / 2;

    private readonly record struct Direction(double X, double Y, double Z)
    {
        public Direction Unit => this * (1 / Math.Sqrt(Dot(this)));

        public static Direction operator +(Direction a, Direction b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

        public static Direction operator *(Direction a, double s) => new(a.X * s, a.Y * s, a.Z * s);

        public double Dot(Direction d) => (X * d.X) + (Y * d.Y) + (Z * d.Z);

        public Direction Cross(Direction d) => new((Y * d.Z) - (Z * d.Y), (Z * d.X) - (X * d.Z), (X * d.Y) - (Y * d.X));

        public Direction Mirror(Direction w) => (this * (2 * Dot(w))) + new Direction(-w.X, -w.Y, -w.Z);
    }
}
