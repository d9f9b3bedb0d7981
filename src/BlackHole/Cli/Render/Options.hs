-- | The options of @blackhole render@.
module BlackHole.Cli.Render.Options
  ( RenderOptions (..),
    renderOptions,
    renderTarget,
    renderUsageProblems,
  )
where

import BlackHole.Cli.Check (checkThreads)
import BlackHole.Cli.CodingOptions (codingOptions)
import BlackHole.Cli.PictureOutput (outputFormat, unknownExtensionOf)
import BlackHole.Cli.Read
import BlackHole.Cli.RunOptions
import BlackHole.Cli.SceneOptions
import BlackHole.Cli.Tile
import BlackHole.Image.Coding
import BlackHole.Render.Shard (Shard)
import BlackHole.Scene.Problem (Problem (..))
import Data.Maybe (fromMaybe, isJust)
import Options.Applicative

-- | The options of @blackhole render@.
data RenderOptions = RenderOptions
  { renderScene :: !SceneOptions,
    -- | A picture whose stored scene to start from.
    renderFrom :: !(Maybe FilePath),
    renderCoding :: !Coding,
    -- | Draw in the terminal instead of writing a file.
    renderPreview :: !Bool,
    renderThreads :: !(Maybe Int),
    -- | Column and row of a pixel to explain instead of rendering.
    renderPixel :: !(Maybe (Int, Int)),
    renderTile :: !(Maybe Shard),
    renderRun :: !RunOptions,
    -- | The value of @--output@, if it is given; see 'renderTarget'.
    renderOutput :: !(Maybe FilePath)
  }
  deriving (Eq, Show)

-- | The file to write.
renderTarget :: RenderOptions -> FilePath
renderTarget = fromMaybe "blackhole.png" . renderOutput

-- | Their parser.
renderOptions :: Parser RenderOptions
renderOptions =
  RenderOptions
    <$> sceneOptions
    <*> setting
      ( strOption
          ( long "from" <> metavar "PICTURE" <> filesEnding (map fst formatExtensions)
              <> help "Start from the scene stored in a picture that this program wrote"
          )
      )
    <*> codingOptions
    <*> toggle (long "preview" <> help "Draw the picture in the terminal instead of writing a file")
    <*> threadsOption
    <*> setting
      ( option
          pixelPlace
          ( long "pixel" <> metavar "X,Y"
              <> help "Explain the colour of one pixel instead of rendering; 0,0 is the top left"
          )
      )
    <*> setting
      ( option
          tilePart
          ( long "tile" <> metavar "I/N"
              <> help
                "Render part I of N, a band of rows, to a tile file (-o FILE.tile) for \
                \blackhole join"
          )
      )
    <*> runOptions
    <*> setting
      ( strOption
          ( long "output" <> short 'o' <> metavar "FILE" <> action "file"
              <> help
                "File to write: .png, .jpg, .tif, .hdr or .exr; - writes a PNG to standard output \
                \(default: blackhole.png)"
          )
      )

-- | The problems of the options that do not depend on the scene.
renderUsageProblems :: RenderOptions -> [Problem]
renderUsageProblems options =
  ( if null (renderTile options)
      then [unknownExtensionOf output | Nothing <- [outputFormat output]]
      else tileNameProblems output
  )
    ++ checkThreads (renderThreads options)
    ++ idleRenderOptions options
    ++ [ Mistake "--from" "cannot be combined with a scene file"
         | Just _ <- [renderFrom options],
           Just _ <- [sceneFile (renderScene options)]
       ]
  where
    output = renderTarget options

-- | The options that have no effect beside others: for each option, whether it is given,
-- and the modes in which it does nothing.
idleRenderOptions :: RenderOptions -> [Problem]
idleRenderOptions options =
  [ Mistake name ("has no effect with " ++ mode)
    | (name, True, modes) <- table,
      (mode, True) <- take 1 (filter snd modes)
  ]
  where
    table =
      [ ("--output", isJust (renderOutput options), [pixel, previewed]),
        ("--bits", isJust (codingBits coding), [pixel, previewed, tile]),
        ("--quality", isJust (codingQuality coding), [pixel, previewed, tile]),
        ("--preview", renderPreview options, [pixel]),
        ("--tile", isJust (renderTile options), [pixel, previewed]),
        ("--threads", isJust (renderThreads options), [pixel]),
        ("--progress", isJust (reportProgress reported), [pixel, previewed]),
        ("--stats", isJust (reportStats reported), [pixel, previewed]),
        ("--strict", runStrict how, [pixel, previewed]),
        ("--keep-partial", runKeepPartial how, [pixel, previewed, tile]),
        ( "--preset",
          isJust (scenePreset (renderScene options)),
          [("--from", isJust (renderFrom options))]
        )
      ]
    pixel = ("--pixel", isJust (renderPixel options))
    previewed = ("--preview", renderPreview options)
    tile = ("--tile", isJust (renderTile options))
    coding = renderCoding options
    how = renderRun options
    reported = runReporting how
