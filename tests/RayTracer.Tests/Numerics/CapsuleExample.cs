using RayTracer.Numerics;

namespace RayTracer.Tests.Numerics;

/// <summary>The example of docs/thinking-in-lanes.md: <see cref="FloatW.Max"/> and <see cref="FloatW.Min"/> where one of two numbers is NaN.</summary>
public class CapsuleExample
{
    [Fact]
    public void A_capsule_that_forgets_NaN_has_no_end_to_its_sides()
    {
        // One lane meets the middle, the others pass on the right, ever farther; down at a slant, from above the slab.
        Vec3W origin = new(FloatW.Iota * 3f, 2f, 0f);
        Vec3W down = new(0f, -1f, 0.1f);
        Assert.Equal(Right(origin, down)[0], Wrong(origin, down)[0]);
        for (int lane = 1; lane < FloatW.Count; lane++)
        {
            Assert.Equal(1, Wrong(origin, down)[lane]);
            Assert.True(float.IsNaN(Right(origin, down)[lane]));
        }
    }

    [Fact]
    public void The_page_shows_the_code_that_is_run()
    {
        string code = File.ReadAllText(ProjectFolder.PathOf("tests", "RayTracer.Tests", "Numerics", "CapsuleExample.cs")).ReplaceLineEndings("\n");
        string page = File.ReadAllText(ProjectFolder.PathOf("docs", "thinking-in-lanes.md")).ReplaceLineEndings("\n");
        foreach (string example in code.Split("    // example\n").Skip(1).Select(part => part.Split("    // end\n", 2)[0].TrimEnd()))
        {
            string shown = string.Join('\n', example.Split('\n').Select(line => line.StartsWith("    ", StringComparison.Ordinal) ? line[4..] : line));
            Assert.Contains($"```csharp\n{shown}\n```", page, StringComparison.Ordinal);
        }
    }

    // example
    // The straight part of a capsule: a tube of radius 1 around the y axis, between the heights -1 and 1.
    private static FloatW Wrong(in Vec3W origin, in Vec3W direction)
    {
        Tube(origin, direction, out FloatW tubeNear, out FloatW tubeFar); // NaN where a ray misses the tube
        Slab(origin, direction, out FloatW slabNear, out FloatW slabFar);
        FloatW near = FloatW.Max(tubeNear, slabNear);
        FloatW far = FloatW.Min(tubeFar, slabFar);
        return (near <= far).Select((near > 0f).Select(near, far), float.NaN);
    }

    // end

    // example
    private static FloatW Right(in Vec3W origin, in Vec3W direction)
    {
        Tube(origin, direction, out FloatW tubeNear, out FloatW tubeFar);
        Slab(origin, direction, out FloatW slabNear, out FloatW slabFar);
        FloatW near = FloatW.Max(slabNear, tubeNear); // what may be NaN stands second, and comes through
        FloatW far = FloatW.Min(slabFar, tubeFar);
        return (near <= far).Select((near > 0f).Select(near, far), float.NaN);
    }

    // end
    private static void Tube(in Vec3W origin, in Vec3W direction, out FloatW near, out FloatW far)
    {
        FloatW a = FloatW.MultiplyAdd(direction.X, direction.X, direction.Z * direction.Z);
        FloatW b = FloatW.MultiplyAdd(origin.X, direction.X, origin.Z * direction.Z);
        FloatW c = FloatW.MultiplyAdd(origin.X, origin.X, origin.Z * origin.Z) - 1f;
        FloatW root = FloatW.Sqrt(FloatW.MultiplyAdd(b, b, -(a * c)));
        near = (-b - root) / a;
        far = (-b + root) / a;
    }

    private static void Slab(in Vec3W origin, in Vec3W direction, out FloatW near, out FloatW far)
    {
        FloatW first = (-1f - origin.Y) / direction.Y;
        FloatW second = (1f - origin.Y) / direction.Y;
        near = FloatW.Min(first, second);
        far = FloatW.Max(first, second);
    }
}
