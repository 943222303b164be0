using System.Numerics;

namespace RayTracer.Tests.Acceleration;

/// <summary>Rays and triangles in double precision, by the volumes of tetrahedra: another formula than the product's.</summary>
internal static class OrdinaryTest
{
    /// <summary>The nearest hit, infinite where there is none, and how far the ray keeps from the nearest edge it passes, as a fraction of the triangle.</summary>
    public static (double Distance, double Margin) Closest(TestMesh mesh, Vector3 origin, Vector3 direction, float limit)
    {
        double nearest = double.PositiveInfinity;
        double margin = double.PositiveInfinity;
        for (int triangle = 0; triangle < mesh.Count; triangle++)
        {
            double[] a = Difference(mesh.Corner(triangle, 0), origin);
            double[] b = Difference(mesh.Corner(triangle, 1), origin);
            double[] c = Difference(mesh.Corner(triangle, 2), origin);
            double[] d = [direction.X, direction.Y, direction.Z];
            double u = Volume(d, b, c);
            double v = Volume(d, c, a);
            double w = Volume(d, a, b);
            double total = u + v + w;
            double smallest = Math.Min(u / total, Math.Min(v / total, w / total));
            double distance = Volume(a, b, c) / total;
            margin = Math.Min(margin, Math.Min(Math.Abs(smallest), Math.Min(Math.Abs(distance), Math.Abs((distance / limit) - 1))));
            if (smallest > 0 && distance > 0 && distance < limit)
            {
                nearest = Math.Min(nearest, distance);
            }
        }

        return (nearest, margin);
    }

    private static double[] Difference(Vector3 a, Vector3 b) => [(double)a.X - b.X, (double)a.Y - b.Y, (double)a.Z - b.Z];

    private static double Volume(double[] a, double[] b, double[] c) =>
        (a[0] * ((b[1] * c[2]) - (b[2] * c[1]))) + (a[1] * ((b[2] * c[0]) - (b[0] * c[2]))) + (a[2] * ((b[0] * c[1]) - (b[1] * c[0])));
}
