namespace Lab1;

/// <summary>Where rays meet shapes. All functions return the smallest t above 0 for which ray.At(t) is on the shape, or null where there is none.</summary>
public static class Shapes
{
    /// <summary>A sphere, by algebra: the quadratic equation |O + t·D − C|² = r².</summary>
    /// <param name="ray">The ray; its direction D may have any length.</param>
    /// <param name="center">The centre C.</param>
    /// <param name="radius">The radius r.</param>
    public static double? SphereByAlgebra(Ray ray, Vector center, double radius)
    {
        //? Shapes.SphereByAlgebra: write the equation as a·t² + b·t + c = 0, and solve it.
        Vector from = ray.Origin - center;
        double a = Vector.Dot(ray.Direction, ray.Direction);
        double b = 2 * Vector.Dot(from, ray.Direction);
        double c = Vector.Dot(from, from) - (radius * radius);
        double discriminant = (b * b) - (4 * a * c);
        if (discriminant < 0)
        {
            return null;
        }

        double root = Math.Sqrt(discriminant);
        double near = (-b - root) / (2 * a);
        double far = (-b + root) / (2 * a);
        return near > 0 ? near : far > 0 ? far : null;
        //!
    }

    /// <summary>A sphere, by geometry: the point of the ray that is nearest to the centre, and half of the chord (Pythagoras).</summary>
    /// <param name="ray">The ray; its direction has length 1.</param>
    /// <param name="center">The centre.</param>
    /// <param name="radius">The radius.</param>
    public static double? SphereByGeometry(Ray ray, Vector center, double radius)
    {
        //? Shapes.SphereByGeometry: find the point of the ray that is nearest to the centre, and half of the chord.
        Vector toCenter = center - ray.Origin;
        double middle = Vector.Dot(toCenter, ray.Direction);
        Vector off = toCenter - (middle * ray.Direction);
        double square = (radius * radius) - Vector.Dot(off, off);
        if (square < 0)
        {
            return null;
        }

        double half = Math.Sqrt(square);
        double near = middle - half;
        double far = middle + half;
        return near > 0 ? near : far > 0 ? far : null;
        //!
    }

    /// <summary>A plane without end.</summary>
    /// <param name="ray">The ray.</param>
    /// <param name="point">A point of the plane.</param>
    /// <param name="normal">Its normal.</param>
    public static double? Plane(Ray ray, Vector point, Vector normal)
    {
        //? Shapes.Plane: the vector from the point to ray.At(t) is perpendicular to the normal.
        double t = Vector.Dot(point - ray.Origin, normal) / Vector.Dot(ray.Direction, normal);
        return t > 0 && double.IsFinite(t) ? t : null;
        //!
    }

    /// <summary>A triangle, by Cramer's rule: O + t·D = A + u·(B − A) + v·(C − A).</summary>
    /// <param name="ray">The ray.</param>
    /// <param name="a">The corner A.</param>
    /// <param name="b">The corner B.</param>
    /// <param name="c">The corner C.</param>
    public static double? Triangle(Ray ray, Vector a, Vector b, Vector c)
    {
        //? Shapes.Triangle: three equations for t, u and v. Each is one determinant over another.
        Vector edgeB = b - a;
        Vector edgeC = c - a;
        Vector from = ray.Origin - a;
        double determinant = Determinant(-ray.Direction, edgeB, edgeC);
        double t = Determinant(from, edgeB, edgeC) / determinant;
        double u = Determinant(-ray.Direction, from, edgeC) / determinant;
        double v = Determinant(-ray.Direction, edgeB, from) / determinant;
        return t > 0 && u >= 0 && v >= 0 && u + v <= 1 ? t : null;
        //!
    }

    /// <summary>
    /// A triangle without cracks (Woop, Benthin and Wald, Watertight Ray/Triangle Intersection, 2013): a ray that meets the edge that two triangles share
    /// meets at least one of them, whatever is rounded.
    /// </summary>
    /// <param name="ray">The ray.</param>
    /// <param name="a">The corner A.</param>
    /// <param name="b">The corner B.</param>
    /// <param name="c">The corner C.</param>
    public static double? WatertightTriangle(Ray ray, Vector a, Vector b, Vector c)
    {
        //? Shapes.WatertightTriangle: look along the ray, so that it is the point (0, 0), and ask on which side of each edge that lies.
        (Vector p, Vector q, Vector r) = (Along(ray, a), Along(ray, b), Along(ray, c));

        // Twice the areas of the triangles of the ray with two corners. The same edge, walked the other way, has exactly the opposite number.
        double ofA = (q.X * r.Y) - (q.Y * r.X);
        double ofB = (r.X * p.Y) - (r.Y * p.X);
        double ofC = (p.X * q.Y) - (p.Y * q.X);
        bool isInside = (ofA >= 0 && ofB >= 0 && ofC >= 0) || (ofA <= 0 && ofB <= 0 && ofC <= 0);
        double sum = ofA + ofB + ofC;
        if (!isInside || sum == 0)
        {
            return null;
        }

        double t = ((ofA * p.Z) + (ofB * q.Z) + (ofC * r.Z)) / sum;
        return t > 0 ? t : null;
        //!
    }

    /// <summary>The determinant of the matrix with these columns.</summary>
    public static double Determinant(Vector x, Vector y, Vector z) => Vector.Dot(x, Vector.Cross(y, z));

    /// <summary>
    /// A point as it is seen along a ray: relative to the ray's origin, and sheared so that the ray goes along the third axis. Points on the ray have x = y = 0,
    /// and z is their t, with a minus where they lie behind the origin. It is computed for each point by itself, so that a corner that triangles share is the same for all of them.
    /// </summary>
    public static Vector Along(Ray ray, Vector point)
    {
        // The axis along which the direction is longest comes last.
        int z = Math.Abs(ray.Direction.X) > Math.Abs(ray.Direction.Y)
            ? Math.Abs(ray.Direction.X) > Math.Abs(ray.Direction.Z) ? 0 : 2
            : Math.Abs(ray.Direction.Y) > Math.Abs(ray.Direction.Z) ? 1 : 2;
        (int x, int y) = ((z + 1) % 3, (z + 2) % 3);
        Vector from = point - ray.Origin;
        double t = from[z] / ray.Direction[z];
        return new(from[x] - (t * ray.Direction[x]), from[y] - (t * ray.Direction[y]), t);
    }
}
