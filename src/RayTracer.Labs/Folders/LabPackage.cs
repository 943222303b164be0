using System.IO.Compression;
using RayTracer.Imaging;

namespace RayTracer.Labs;

/// <summary>
/// The package that a lab's project takes: the libraries that lie beside this program, so that neither a network nor a clone is needed, and a lab keeps
/// its version when the program is renewed.
/// </summary>
internal static class LabPackage
{
    /// <summary>Its name.</summary>
    public const string Name = "RayTracer.Lab";

    /// <summary>Its version: the program's.</summary>
    public static string Version { get; } = typeof(LabPackage).Assembly.GetName().Version!.ToString(3);

    /// <summary>Writes it.</summary>
    /// <param name="folder">The folder, which becomes a source of packages.</param>
    /// <exception cref="LabException">The libraries are not there.</exception>
    public static void Write(string folder)
    {
        if (Compiler.Libraries.FirstOrDefault(l => !File.Exists(l)) is { } missing)
        {
            throw new LabException($"labs need the command as a .NET tool, or built from its sources: there is no '{missing}'");
        }

        Directory.CreateDirectory(folder);
        AtomicFile.Write(Path.Combine(folder, $"{Name}.{Version}.nupkg"), stream =>
        {
            using ZipArchive package = new(stream, ZipArchiveMode.Create, leaveOpen: true);
            using (StreamWriter specification = new(package.CreateEntry($"{Name}.nuspec").Open()))
            {
                specification.Write($"""
                    <package xmlns="http://schemas.microsoft.com/packaging/2013/05/nuspec.xsd">
                      <metadata>
                        <id>{Name}</id>
                        <version>{Version}</version>
                        <authors>The RayTracer developers</authors>
                        <description>What the labs of the course are written against: the textbook edition, and what their checks use.</description>
                      </metadata>
                    </package>
                    """);
            }

            // With the documentation, which editors show.
            foreach (string file in Compiler.Libraries.Concat(Compiler.Libraries.Select(l => Path.ChangeExtension(l, ".xml")).Where(File.Exists)))
            {
                package.CreateEntryFromFile(file, $"lib/net10.0/{Path.GetFileName(file)}");
            }
        });
    }
}
