using System.Diagnostics;
using System.Reflection;
using System.Text.RegularExpressions;
using RayTracer.Desktop.ViewModels;
using RayTracer.Session;

namespace RayTracer.Desktop.Tests;

/// <summary>View models know nothing of Avalonia, and wait for nobody.</summary>
public sealed class ViewModelTests
{
    private const BindingFlags All = BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly;
    private static readonly string Sources = ProjectFolder.PathOf("src", "RayTracer.Desktop");

    [Fact]
    public void View_models_reference_no_type_of_Avalonia()
    {
        Type[] types = [.. typeof(MainViewModel).Assembly.GetTypes().Where(t => t.Namespace == typeof(MainViewModel).Namespace || t.FullName!.StartsWith(typeof(MainViewModel).Namespace + ".", StringComparison.Ordinal))];
        Assert.True(types.Length > 60);
        Assert.Equal([], types.SelectMany(t => Used(t).Where(IsOfAvalonia).Select(u => $"{t.Name}: {u}")));

        // And none within methods.
        Assert.Equal([], Directory.GetFiles(Path.Combine(Sources, "ViewModels"), "*.cs", SearchOption.AllDirectories).Where(f => File.ReadAllText(f).Contains("Avalonia.", StringComparison.Ordinal)));
    }

    [Fact]
    public void Every_text_that_is_named_is_there()
    {
        List<string> places = [];
        foreach (string file in Directory.GetFiles(Sources, "*.*", SearchOption.AllDirectories).Where(f => Path.GetExtension(f) is ".cs" or ".axaml" && !f.Contains($"{Path.DirectorySeparatorChar}obj{Path.DirectorySeparatorChar}", StringComparison.Ordinal)))
        {
            places.AddRange(Regex.Matches(File.ReadAllText(file), """(?:\{c:Text |SessionTexts\.Of\(")([\w.]+)[}"]""", RegexOptions.None, TimeSpan.FromSeconds(10)).Select(m => m.Groups[1].Value));
        }

        Assert.True(places.Count > 100);
        foreach (string place in places)
        {
            Assert.NotEmpty(SessionTexts.Of(place));
        }

        Assert.Throws<KeyNotFoundException>(() => SessionTexts.Of("nothing.here"));
        Assert.Equal("3 of 8 samples", SessionTexts.Of("status.samples", 3, 8));
        Assert.Equal("On the clipboard: {x}", SessionTexts.Of("messages.copiedCommand", "{x}"));
    }

    [Fact]
    public void Every_view_binds_at_compile_time_to_a_view_model()
    {
        string[] views = Directory.GetFiles(Path.Combine(Sources, "Views"), "*.axaml");
        Assert.True(views.Length > 15);
        Assert.All(views, v => Assert.Contains("x:DataType=\"vm:", File.ReadAllText(v), StringComparison.Ordinal));
        Assert.All(views, v => Assert.DoesNotContain("ReflectionBinding", File.ReadAllText(v), StringComparison.Ordinal));
    }

    [Fact]
    public void The_windows_thread_waits_for_nobody() => Ui.Run(async () =>
    {
        using TestWindow test = await TestWindow.Open();
        using ManualResetEventSlim gate = new();
        Task<bool> busy = test.Main.Dispatcher.Ask(_ => gate.Wait(TimeSpan.FromMinutes(1)));

        // While the session is busy, everything that the user can do comes back at once: else this would never get to the gate.
        string[] closing = ["open", "new"];
        foreach (CommandViewModel command in test.Main.Commands.Menus.SelectMany(m => m.Commands).Where(c => !closing.Contains(c.Id)))
        {
            command.Execute(null);
        }

        test.Main.Dialog?.Cancel.Execute(null);
        test.Main.Viewport.Press(new(100, 100), PointerButton.Main, HeldKeys.None);
        test.Main.Viewport.Move(new(150, 100));
        test.Main.Viewport.Release(new(150, 100));
        test.Main.Source.Text += " ";
        test.Layout();
        Assert.False(busy.IsCompleted);
        gate.Set();
        Assert.True(await busy);
    });

    [Fact]
    public void What_is_typed_is_put_into_what_others_have_changed_meanwhile()
    {
        TextStretch typed = TextStretch.Between("one two three", "one two 2 three")!;
        Assert.Equal("zero one two 2 three", typed.After(TextStretch.Between("one two three", "zero one two three"))!.Apply("zero one two three"));
        Assert.Equal("one two 2 four", typed.After(TextStretch.Between("one two three", "one two four"))!.Apply("one two four"));
        Assert.Null(typed.After(TextStretch.Between("one two three", "nothing")));
        Assert.Null(TextStretch.Between("a", "a"));
        Assert.Equal("aba", TextStretch.Between("aa", "aba")!.Apply("aa"));
    }

    [Fact]
    public void Numbers_are_read_and_written_as_in_the_Studio()
    {
        Assert.Equal(["0.333333", "−2", "∞", "–"], new[] { 1 / 3.0, -2, double.PositiveInfinity, double.NaN }.Select(n => Figures.Short(n)));
        Assert.Equal([1.5, -2, null, null], new[] { " 1,5 ", "−2", "two", "" }.Select(Figures.Parse));
        Assert.Equal(["31.4 M", "120 "], new[] { 31.4e6, 120 }.Select(Figures.WithPrefix));
        Assert.Equal(["4.2 s", "45 s", "3:07", "1:02:05"], new[] { 4.2, 45, 187, 3725 }.Select(Figures.Duration));
        Assert.Equal("samples per pixel", Figures.Spaced("samplesPerPixel"));
    }

    [SkippableFact]
    public void Without_Avalonias_platform_the_program_says_so_in_a_sentence()
    {
        string program = Path.Combine(AppContext.BaseDirectory, "RayTracer.Desktop.dll");
        Skip.If(File.Exists(Path.Combine(AppContext.BaseDirectory, "Avalonia.Skia.dll")), "Avalonia is whole here.");
        using Process process = Process.Start(new ProcessStartInfo("dotnet", [program]) { UseShellExecute = false, RedirectStandardError = true, RedirectStandardOutput = true })!;
        string errors = process.StandardError.ReadToEnd();
        Assert.Equal("", process.StandardOutput.ReadToEnd());
        process.WaitForExit();
        Assert.NotEqual(0, process.ExitCode);
        Assert.Single(errors.TrimEnd().Split('\n'));
        Assert.Contains("dotnet run -c Release --project src/RayTracer.Studio", errors, StringComparison.Ordinal);
    }

    private static bool IsOfAvalonia(Type type) =>
        (type.HasElementType && IsOfAvalonia(type.GetElementType()!)) || type.Assembly.GetName().Name!.StartsWith("Avalonia", StringComparison.Ordinal) || type.GetGenericArguments().Any(IsOfAvalonia);

    private static IEnumerable<Type> Used(Type type) =>
    [
        .. type.BaseType is { } parent ? [parent] : Type.EmptyTypes, .. type.GetInterfaces(),
        .. type.GetFields(All).Select(f => f.FieldType), .. type.GetProperties(All).Select(p => p.PropertyType),
        .. type.GetMethods(All).SelectMany(m => m.GetParameters().Select(p => p.ParameterType).Append(m.ReturnType)),
        .. type.GetConstructors(All).SelectMany(c => c.GetParameters()).Select(p => p.ParameterType),
    ];
}
