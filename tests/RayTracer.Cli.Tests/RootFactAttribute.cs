namespace RayTracer.Cli.Tests;

/// <summary>A test that mounts a file system, and is skipped with that reason where that needs rights that are not there.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class RootFactAttribute : FactAttribute
{
    public RootFactAttribute()
    {
        string folder = Directory.CreateTempSubdirectory("raytracer-mount-").FullName;
        try
        {
            bool mounts = OperatingSystem.IsLinux() && Environment.IsPrivilegedProcess
                && ProgramFactAttribute.Run("mount", "-t", "tmpfs", "-o", "size=16k", "tmpfs", folder).ExitCode == 0
                && ProgramFactAttribute.Run("umount", folder).ExitCode == 0;
            Skip = mounts ? null : "it mounts a small file system, which is not permitted here";
        }
        finally
        {
            Directory.Delete(folder);
        }
    }
}
