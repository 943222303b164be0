using System.Collections.Concurrent;
using System.Runtime.ExceptionServices;
using Avalonia;
using Avalonia.Input;
using Avalonia.Input.Platform;
using Avalonia.Logging;
using Avalonia.Platform;
using Avalonia.Rendering;
using Avalonia.Threading;

namespace RayTracer.Desktop.Tests;

/// <summary>
/// A thread with Avalonia on a stand-in for a platform: fonts of one width, bitmaps in memory, windows that nobody sees. Styles, templates, layout, bindings
/// and input are Avalonia's own; what is drawn is not looked at.
/// </summary>
internal static class Ui
{
    // Only so that a fault is reported instead of waited for: nothing is measured by it.
    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(30);
    private static readonly BlockingCollection<Action> Work = [];
    private static readonly Lazy<Thread> Started = new(Start);
    private static UiDispatcher? s_dispatcher;

    /// <summary>What Avalonia complains about.</summary>
    public static BindingLog Log { get; } = new();

    /// <summary>Runs a test on the window's thread, which goes on with its other work wherever the test waits.</summary>
    public static void Run(Func<Task> test)
    {
        _ = Started.Value;
        using ManualResetEventSlim done = new();
        ExceptionDispatchInfo? fault = null;
        Work.Add(() =>
        {
            try
            {
                Log.Take();
                Task task = test();
                Pump(() => task.IsCompleted);
                task.GetAwaiter().GetResult();
            }
            catch (Exception e)
            {
                fault = ExceptionDispatchInfo.Capture(e);
            }
            finally
            {
                done.Set();
            }
        });
        done.Wait();
        fault?.Throw();
    }

    /// <summary>Waits until something is so, while the window's thread works.</summary>
    public static async Task Until(Func<bool> isSo, string what)
    {
        DateTime end = DateTime.UtcNow + Patience;
        while (!isSo())
        {
            Assert.True(DateTime.UtcNow < end, $"It did not come to this: {what}.");
            await Task.Delay(5);
        }
    }

    private static void Pump(Func<bool> isDone)
    {
        while (!isDone())
        {
            Dispatcher.UIThread.RunJobs();
            s_dispatcher!.Wait();
        }
    }

    private static Thread Start()
    {
        Thread thread = new(() =>
        {
            SetUp();
            foreach (Action work in Work.GetConsumingEnumerable())
            {
                work();
            }
        })
        { IsBackground = true, Name = "window" };
        s_dispatcher = new(thread);
        thread.Start();
        return thread;
    }

    private static void SetUp()
    {
        Fonts fonts = new();
        AppBuilder.Configure<App>()
            .UseStandardRuntimePlatformSubsystem()
            .UseWindowingSubsystem(
                () => AvaloniaLocator.CurrentMutable
                    .Bind<IDispatcherImpl>().ToConstant(s_dispatcher!)
                    .Bind<IWindowingPlatform>().ToConstant(Stub.Of<IWindowingPlatform>((method, _) => method.Name == "CreateWindow" ? (true, new WindowStub().Window) : (false, null)))
                    .Bind<ICursorFactory>().ToConstant(Stub.Of<ICursorFactory>())
                    .Bind<PlatformHotkeyConfiguration>().ToConstant(new PlatformHotkeyConfiguration(KeyModifiers.Control))
                    .Bind<IPlatformSettings>().ToConstant(new DefaultPlatformSettings())
                    .Bind<IRenderTimer>().ToConstant(Stub.Of<IRenderTimer>())
                    .Bind<IKeyboardDevice>().ToConstant(new KeyboardDevice()),
                "stand-in")
            .UseRenderingSubsystem(
                () => AvaloniaLocator.CurrentMutable
                    .Bind<IPlatformRenderInterface>().ToConstant(Stub.Of<IPlatformRenderInterface>((method, args) => Bitmap(method.Name, args)))
                    .Bind<IFontManagerImpl>().ToConstant(fonts)
                    .Bind<ITextShaperImpl>().ToConstant(fonts),
                "stand-in")
            .SetupWithoutStarting();
        Logger.Sink = Log;
    }

    private static (bool, object?) Bitmap(string name, object?[] args) => (name, args) switch
    {
        ("CreateWriteableBitmap", [PixelSize size, _, PixelFormat format, ..]) => (true, new MemoryBitmap(size, format)),
        ("LoadBitmap", [Stream png]) => (true, new MemoryBitmap(SizeOf(png), PixelFormat.Rgba8888)),
        ("IsSupportedBitmapPixelFormat", _) => (true, true),
        _ => (false, null),
    };

    // Width and height stand in a PNG file's first chunk.
    private static PixelSize SizeOf(Stream png)
    {
        byte[] head = new byte[24];
        png.ReadExactly(head);
        return new(System.Buffers.Binary.BinaryPrimitives.ReadInt32BigEndian(head.AsSpan(16)), System.Buffers.Binary.BinaryPrimitives.ReadInt32BigEndian(head.AsSpan(20)));
    }
}
