namespace RayTracer.Testing;

/// <summary>A test that is left to the thorough run, as others like it run every day. It is of the category "Thorough".</summary>
[AttributeUsage(AttributeTargets.Method)]
internal sealed class ThoroughFactAttribute : SkippableFactAttribute
{
    /// <summary>Creates it; the test is skipped with the reason unless the run is thorough.</summary>
    public ThoroughFactAttribute()
    {
        if (!TestSettings.Thorough)
        {
            Skip = "only in a thorough run (RAYTRACER_THOROUGH=1)";
        }
    }
}
