namespace Lab8;

/// <summary>A ray of single precision. Its direction has the length 1.</summary>
public readonly record struct FloatRay(float X, float Y, float Z, float DirectionX, float DirectionY, float DirectionZ);

/// <summary>A ball.</summary>
public readonly record struct Ball(float X, float Y, float Z, float Radius);

/// <summary>One ray at a time: there is nothing to write here. Yours must have the same bits.</summary>
public static class Scalar
{
    /// <summary>The product of two vectors.</summary>
    public static float Dot(float ax, float ay, float az, float bx, float by, float bz) => (ax * bx) + (ay * by) + (az * bz);

    /// <summary>The distance at which a ray meets a ball in front of it; infinite for none.</summary>
    public static float Meet(in FloatRay ray, in Ball ball)
    {
        (float x, float y, float z) = (ball.X - ray.X, ball.Y - ray.Y, ball.Z - ray.Z);
        float middle = Dot(x, y, z, ray.DirectionX, ray.DirectionY, ray.DirectionZ);
        float square = (middle * middle) - (Dot(x, y, z, x, y, z) - (ball.Radius * ball.Radius));
        if (square < 0)
        {
            return float.PositiveInfinity;
        }

        float root = MathF.Sqrt(square);
        if (middle - root > 0)
        {
            return middle - root;
        }

        return middle + root > 0 ? middle + root : float.PositiveInfinity;
    }

    /// <summary>The nearest ball that a ray meets: its distance and number; infinite and −1 for none. Of two at the same distance, the first.</summary>
    public static (float Distance, int Index) Nearest(in FloatRay ray, Ball[] balls)
    {
        (float distance, int index) = (float.PositiveInfinity, -1);
        for (int i = 0; i < balls.Length; i++)
        {
            float here = Meet(ray, balls[i]);
            if (here < distance)
            {
                (distance, index) = (here, i);
            }
        }

        return (distance, index);
    }
}
