using System.Text.Json;
using Markdig;
using RayTracer.Imaging;

namespace RayTracer.Labs;

/// <summary>The folder in which a student works on a lab.</summary>
/// <param name="Path">The folder.</param>
/// <param name="Card">What its file <c>lab.json</c> says.</param>
public sealed record LabFolder(string Path, LabCard Card)
{
    /// <summary>The name of the folder of the checks.</summary>
    internal const string Checks = "checks";

    /// <summary>The file that says which lab it is, and whose.</summary>
    internal const string CardName = "lab.json";

    private const int MostOfCard = 10_000;

    // Compiling takes a few seconds, and longer where all processors are busy.
    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(120);
    private static readonly MarkdownPipeline s_markdown = new MarkdownPipelineBuilder().UsePipeTables().DisableHtml().Build();

    /// <summary>The namespaces that a lab's project uses everywhere.</summary>
    internal static IReadOnlyList<string> Usings { get; } = ["RayTracer.Textbook"];

    /// <summary>The student's sources.</summary>
    /// <exception cref="LabException">There are none.</exception>
    public IReadOnlyList<string> Sources
    {
        get
        {
            string[] sources =
            [
                .. Directory.EnumerateFiles(Path, "*.cs", SearchOption.AllDirectories).Where(f => IsSource(System.IO.Path.GetRelativePath(Path, f))).Order(StringComparer.Ordinal),
            ];
            return sources.Length > 0 ? sources : throw new LabException($"there are no .cs files in '{Path}'");
        }
    }

    /// <summary>Makes a folder for a lab, with all that it needs.</summary>
    /// <param name="lab">The lab.</param>
    /// <param name="path">The folder; it must be empty, or not be there.</param>
    /// <param name="student">The student's name.</param>
    /// <exception cref="LabException">There are files already, or the libraries do not lie beside this program.</exception>
    /// <exception cref="IOException">It cannot be written.</exception>
    public static LabFolder Make(Lab lab, string path, string student)
    {
        path = System.IO.Path.GetFullPath(path);
        if (Directory.Exists(path) && Directory.EnumerateFileSystemEntries(path).Any())
        {
            throw new LabException($"'{path}' is not empty: give another one with --folder");
        }

        LabFolder folder = new(path, new(lab.Number, student, LabPackage.Version));
        LabPackage.Write(System.IO.Path.Combine(path, "packages"));
        foreach (string file in lab.Files(""))
        {
            string target = System.IO.Path.Combine(path, file.Replace("starter/", "", StringComparison.Ordinal));
            Directory.CreateDirectory(System.IO.Path.GetDirectoryName(target)!);
            using Stream content = lab.Open(file);
            AtomicFile.Write(target, content.CopyTo);
        }

        folder.Write("handout.html", StandalonePage.Of(lab.Title, Markdown.ToHtml(lab.Text("handout.md"), s_markdown)));
        folder.Write(CardName, JsonSerializer.Serialize(folder.Card, LabCard.Json));
        folder.Write($"Lab{lab.Number}.csproj", Project);
        folder.Write("nuget.config", Feed);
        folder.Write(".gitignore", "bin/\nobj/\nreport/\n");
        return folder;
    }

    /// <summary>Opens the folder of a lab.</summary>
    /// <param name="path">The folder.</param>
    /// <exception cref="LabException">It is none.</exception>
    public static LabFolder Open(string path)
    {
        path = System.IO.Path.GetFullPath(path);
        FileInfo card = new(System.IO.Path.Combine(path, CardName));
        if (!card.Exists)
        {
            throw new LabException($"'{path}' is no lab, as it has no {CardName}: \"raytracer lab new 1\" makes one");
        }

        return card.Length > MostOfCard ? throw new LabException($"{card.FullName} is too long") : new(path, LabCard.Read(File.ReadAllText(card.FullName), card.FullName));
    }

    /// <summary>Compiles the student's sources together with the checks of this program.</summary>
    /// <param name="folder">A folder for what is compiled.</param>
    /// <param name="isolate">Returns the command that runs another one in a sandbox.</param>
    /// <returns>The assembly, and the errors; without errors it is there.</returns>
    internal (string Assembly, IReadOnlyList<string> Errors) Compile(string folder, Func<IReadOnlyList<string>, IReadOnlyList<string>> isolate)
    {
        Lab lab = Lab.Of(Card.Lab);
        string assembly = System.IO.Path.Combine(folder, "Lab.dll");
        List<string> checks = [];
        foreach (string file in lab.Files(Checks))
        {
            checks.Add(System.IO.Path.Combine(folder, $"{Checks}-{System.IO.Path.GetFileName(file)}"));
            File.WriteAllText(checks[^1], lab.Text(file));
        }

        return (assembly, Compiler.Run(isolate(Compiler.Command([.. Sources, .. checks], assembly)), s_patience));
    }

    /// <summary>The errors of the compiler; none where all compiles.</summary>
    internal IReadOnlyList<string> Errors()
    {
        DirectoryInfo work = Directory.CreateTempSubdirectory("raytracer-lab-");
        try
        {
            return Compile(work.FullName, command => command).Errors;
        }
        finally
        {
            work.Delete(recursive: true);
        }
    }

    /// <summary>Writes a file.</summary>
    /// <param name="name">Its name.</param>
    /// <param name="text">What is in it.</param>
    /// <returns>Its path.</returns>
    internal string Write(string name, string text)
    {
        string path = System.IO.Path.Combine(Path, name);
        AtomicFile.Write(path, stream => stream.Write(System.Text.Encoding.UTF8.GetBytes(text.ReplaceLineEndings("\n"))));
        return path;
    }

    /// <summary>Returns whether a file is a student's own: no check, and nothing that a build makes.</summary>
    /// <param name="path">Its path from the folder of the lab.</param>
    internal static bool IsSource(string path) =>
        path.EndsWith(".cs", StringComparison.OrdinalIgnoreCase) && !path.Split('/', '\\')[..^1].Any(f => f is "bin" or "obj" or Checks);

    // The package comes from the folder beside it alone, and is kept there: without a network, and whatever other versions there are.
    private const string Feed = """
        <?xml version="1.0" encoding="utf-8"?>
        <configuration>
          <config>
            <add key="globalPackagesFolder" value="obj/packages" />
          </config>
          <packageSources>
            <clear />
            <add key="beside" value="packages" />
          </packageSources>
        </configuration>

        """;

    private static string Project { get; } = $"""
        <Project Sdk="Microsoft.NET.Sdk">
          <PropertyGroup>
            <TargetFramework>net10.0</TargetFramework>
            <Nullable>enable</Nullable>
            <ImplicitUsings>enable</ImplicitUsings>
          </PropertyGroup>
          <ItemGroup>
            <PackageReference Include="{LabPackage.Name}" Version="{LabPackage.Version}" />
        {string.Concat(Usings.Select(u => $"    <Using Include=\"{u}\" />\n"))}  </ItemGroup>
        </Project>

        """;
}
