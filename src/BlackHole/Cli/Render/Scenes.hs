{-# LANGUAGE TupleSections #-}

-- | The scenes that @blackhole render@ renders.
module BlackHole.Cli.Render.Scenes (renderedScenes) where

import BlackHole.Cli.Console (say)
import BlackHole.Cli.Render.Options
import BlackHole.Cli.SceneOptions
import BlackHole.Image.Coding
import BlackHole.Image.File (fileMetadata)
import BlackHole.Image.Metadata
import BlackHole.Scene.Scene (Scene)
import Control.Applicative ((<|>))
import Control.Exception (IOException, try)
import Control.Monad (when)
import qualified Data.ByteString as Bytes
import Data.List.NonEmpty (NonEmpty (..))
import System.IO (IOMode (ReadMode), withBinaryFile)
import System.IO.Error (ioeGetErrorString)

-- | The scene that the options ask for, or all scenes of a picture with motion blur; and
-- the encoding of the file: that of the options, or else that of the picture that the
-- scene comes from. 'Left' holds one line for each problem.
renderedScenes :: RenderOptions -> IO (Either [String] (NonEmpty Scene, Coding))
renderedScenes options = case renderFrom options of
  Nothing -> fmap (\scene -> (scene :| [], asked)) <$> loadScene (renderScene options)
  Just path -> do
    -- The metadata precede the pixels.
    outcome <- try (withBinaryFile path ReadMode (`Bytes.hGet` 0x400000))
    case outcome of
      Left failure ->
        pure
          (Left [path ++ ": cannot be read: " ++ ioeGetErrorString (failure :: IOException)])
      Right bytes -> case fileMetadata bytes of
        Nothing ->
          pure
            (Left [path ++ ": this picture has no scene; only pictures that blackhole wrote do"])
        Just metadata -> do
          when (metadataSoftware metadata /= software) $
            say
              ( "note: " ++ path ++ " was made by " ++ metadataSoftware metadata ++ "; "
                  ++ software
                  ++ " may render it differently"
              )
          pure
            ( (,codingAfter path metadata)
                <$> resolveMetadata (renderScene options) path (metadataScene metadata)
            )
  where
    asked = renderCoding options
    -- Bits and quality are specific to the format.
    codingAfter path metadata
      | formatOf path == formatOf (renderTarget options) =
        let before = metadataCoding metadata
         in Coding
              (codingBits asked <|> codingBits before)
              (codingQuality asked <|> codingQuality before)
      | otherwise = asked
